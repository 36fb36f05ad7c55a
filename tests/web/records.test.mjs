// Structs in records.mjs are those of the C headers: members, their order and their types.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ENUMS, RECORDS } from './node_modules/coif/records.mjs';

const folder = process.env.COIF_C_HEADERS;
const headers = ['coif.h', ...readdirSync(join(folder, 'coif/c')).map((name) => `coif/c/${name}`)];
const code = headers.map((name) => readFileSync(join(folder, name), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '')).join('\n')
  .replace(/COIF_MAX_LODS\]/g, '8]').replace(/COIF_VIEW_CELLS\]/g, '96]');

// Sizes have 32 bits in the module.
const TYPES = { uint8_t: 'u8', int16_t: 'i16', uint16_t: 'u16', uint32_t: 'u32', uint64_t: 'u64', size_t: 'u32', float: 'f32', double: 'f64' };
const VECTORS = { coif_vec3: 3, coif_quat: 4 };
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const pascal = (name) => camel(`_${name.replace(/^coif_/, '')}`);

/** "type name[count]" of each member, as records.mjs has them. */
function members(body) {
  return body.split(';').map((line) => line.trim()).filter((line) => line.length > 0).flatMap((line) => {
    const [, type, names] = /^(?:const )?(\w+)\s+([\s\S]+)$/.exec(line);
    return names.split(',').map((each) => {
      const [, name, counts] = /^\s*(\w+)((?:\[\d+\])*)\s*$/.exec(each);
      const count = counts === '' ? undefined : counts.match(/\d+/g).reduce((product, each) => product * each, 1); // [3][4] is [12]
      if (VECTORS[type]) return `f32 ${camel(name)}[${VECTORS[type]}]`;
      return `${TYPES[type] ?? pascal(type)} ${camel(name)}${count === undefined ? '' : `[${count}]`}`;
    });
  });
}

const structs = new Map([...code.matchAll(/typedef struct (coif_\w+) \{([^}]*)\}/g)].map(([, name, body]) => [pascal(name), body]));

for (const { name, fields } of Object.values(RECORDS)) {
  test(`${name} is C's`, () => {
    assert.ok(structs.has(name), `C has no ${name}`);
    const own = [...fields].map(([key, { type, count }]) => `${type} ${key}${count === 0 ? '' : `[${count}]`}`);
    assert.deepEqual(own, members(structs.get(name)));
  });
}

test('enumerators have the numbers of C', () => {
  const numbers = (prefix) => [...code.matchAll(new RegExp(`\\b${prefix}(\\w+) = (\\d+)`, 'g'))];
  for (const [, name, number] of numbers('COIF_SOLVER_')) assert.equal(ENUMS.solver[number], name.toLowerCase());
  const shapes = /typedef enum coif_collider_shape \{([\s\S]*?)\}/.exec(code)[1];
  const found = [...shapes.matchAll(/COIF_(\w+) = (\d+)/g)];
  assert.equal(found.length, ENUMS.shape.length);
  for (const [, name, number] of found) assert.equal(ENUMS.shape[number], name.toLowerCase().replaceAll('_', '-'));
});
