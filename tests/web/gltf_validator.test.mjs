// The Khronos validator against this project: what is written as glTF here has no error there, and what has an error there is not
// called valid here.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { mutants } from './gltf_mutants.mjs';

const { COIF, COIF_SAMPLES, COIF_TEST_ASSETS } = process.env;
const WORK = 'gltf_validator';
mkdirSync(WORK, { recursive: true });

/** Kinds of errors that `coif validate` lets pass, each with its reason. */
const LISTED = {
  ACCESSOR_WEIGHTS_NON_NORMALIZED: 'the validator sums each set of four by itself; the specification says all sets together. Also what rounding leaves below 0.0005',
  ACCESSOR_WEIGHTS_NEGATIVE: 'what rounding leaves below 0.000001 of a subtraction',
  IO_ERROR: 'an image that is absent: a warning of the cook where hair uses it (C144), nothing to the mesh',
  IMAGE_DATA_INVALID: 'images are judged where they are decoded: C147 where hair uses it',
  IMAGE_UNRECOGNIZED_FORMAT: 'the same',
};

function* files(at, suffixes) {
  for (const name of readdirSync(at).sort()) {
    const path = join(at, name);
    if (statSync(path).isDirectory()) yield* files(path, suffixes);
    else if (suffixes.has(extname(name).toLowerCase())) yield path;
  }
}

/** The validator's errors, by kind; null where it takes the bytes for no glTF at all. */
async function errorsOf(path) {
  const beside = async (uri) => new Uint8Array(readFileSync(join(dirname(path), decodeURIComponent(uri))));
  try {
    const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(path)), { maxIssues: 0, externalResourceFunction: beside });
    const kinds = {};
    for (const { severity, code } of issues.messages) if (severity === 0) kinds[code] = (kinds[code] ?? 0) + 1;
    return kinds;
  } catch {
    return null;
  }
}

const told = (kinds) => Object.entries(kinds).map(([code, count]) => `${count} ${code}`).join(', ');

/** Exit code of a verb. */
const coif = (...args) => spawnSync(COIF, args, { stdio: 'ignore' }).status;

async function assertNoError(path) {
  assert.equal(told((await errorsOf(path)) ?? { 'no glTF': 1 }), '', path);
}

for (const sample of files(COIF_SAMPLES, new Set(['.glb', '.gltf']))) {
  test(`sample ${basename(sample)} has no error`, () => assertNoError(sample));
}

/** Cooks a source and records it in ways that write different files. */
async function checkRecordings(source) {
  const name = basename(source).replaceAll('.', '_');
  const asset = join(WORK, `${name}.coif`);
  if (coif('cook', source, '--draft', '-o', asset, '--max-seconds', '60') !== 0) return 0;
  const ways = [['--motion', 'turn', '--seconds', '0.3'], ['--motion', 'teleport', '--seconds', '2.1', '--fps', '10', '--scale', '0.5'],
    ['--attitude', '1,0,-1', '--seconds', '0', '--wind', '9,0,3', '--gusts', '4']];
  for (const [i, way] of ways.entries()) {
    const glb = join(WORK, `${name}_${i}.glb`);
    execFileSync(COIF, ['simulate', asset, '--settle', '0', ...way, '-o', glb], { stdio: 'ignore' });
    await assertNoError(glb);
  }
  // A recording is a clip again: of the head, and of the hair's bones.
  const posed = join(WORK, `${name}_posed.glb`);
  execFileSync(COIF, ['simulate', asset, '--settle', '0', '--seconds', '0.2', '--motion', 'nod', '--pose', join(WORK, `${name}_0.glb`), '-o', posed], { stdio: 'ignore' });
  await assertNoError(posed);
  return 1;
}

test('recordings of the samples have no error', async () => {
  for (const name of ['bob', 'long']) assert.equal(await checkRecordings(join(COIF_SAMPLES, name, `${name}.glb`)), 1, name);
});

const corpus = existsSync(COIF_TEST_ASSETS) ? COIF_TEST_ASSETS : null;
if (corpus === null) console.log(`artists' files are not in ${COIF_TEST_ASSETS}; only what the project has is checked`);

test("recordings of artists' files have no error", { skip: corpus === null }, async () => {
  const LEAST = 12; // of those there, so many cook without a recipe
  let cooked = 0;
  for (const source of files(join(corpus, 'hair'), new Set(['.glb', '.vrm', '.fbx', '.obj']))) cooked += await checkRecordings(source);
  assert.ok(cooked >= LEAST, `${cooked} cooked`);
});

/** What coif says of a file: its verdict, and the codes. */
function verdictOf(path) {
  const { stdout } = spawnSync(COIF, ['validate', '--format', 'json', path], { encoding: 'utf8', maxBuffer: 1 << 26 });
  const [file] = JSON.parse(stdout).files;
  return { valid: file.valid, codes: [...new Set(file.issues.map(({ code }) => code))] };
}

/** Prints a row for each file that has errors there, and returns those that are valid here without a reason. */
async function compare(paths) {
  const unexplained = [];
  const counts = { errors: 0, invalid: 0, listed: 0 };
  for (const [label, path] of paths) {
    const kinds = await errorsOf(path);
    if (kinds !== null && Object.keys(kinds).length === 0) continue;
    ++counts.errors;
    const { valid, codes } = verdictOf(path);
    const why = kinds !== null && Object.keys(kinds).every((code) => code in LISTED);
    console.log(`${valid ? (why ? 'listed ' : 'VALID  ') : 'invalid'} ${label}: ${kinds === null ? 'no glTF' : told(kinds)} | ${codes.join(' ')}`);
    ++counts[valid ? 'listed' : 'invalid'];
    if (valid && !why) unexplained.push(label);
  }
  console.log(`${counts.errors} with errors, ${counts.invalid} invalid here, ${counts.listed} valid here`);
  return { unexplained, counts };
}

test('what has an error there is not valid here: files of all kinds', { skip: corpus === null }, async () => {
  const paths = [];
  for (const folder of ['bad', 'hair', 'same_hair', '../cases/reading'].map((name) => join(corpus, name)).filter(existsSync)) {
    for (const path of files(folder, new Set(['.glb', '.gltf', '.vrm']))) paths.push([path.slice(corpus.length + 1), path]);
  }
  const { unexplained, counts } = await compare(paths);
  assert.deepEqual(unexplained, []);
  assert.ok(counts.invalid >= 30, `${counts.invalid}`);
});

test('what has an error there is not valid here: mutated files', async () => {
  const paths = [];
  for (const [name, bytes] of mutants(readFileSync(join(COIF_SAMPLES, 'bob', 'bob.glb')))) {
    const path = join(WORK, `mutant_${name}.glb`);
    writeFileSync(path, bytes);
    paths.push([name, path]);
  }
  const { unexplained, counts } = await compare(paths);
  assert.deepEqual(unexplained, []);
  assert.ok(counts.invalid >= 60, `${counts.invalid}`);
});
