// A server for the tests' pages, and Chromium in which they run.

import { strict as assert } from 'node:assert';
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { after, before } from 'node:test';
import { launch } from './browser.mjs';

const { PACKAGE, ASSET, THREE = 'three' } = process.env; // THREE: the folder of node_modules with the version of three under test
const HERE = import.meta.dirname ?? new URL('.', import.meta.url).pathname;
const TYPES = { '.html': 'text/html', '.mjs': 'text/javascript', '.js': 'text/javascript', '.wasm': 'application/wasm' };

/** Where what a page asks for lies. `pages`: pages and scripts that tests make up. */
export const pages = new Map([['/favicon.ico', '']]);
function fileOf(path) {
  if (path === '/asset.coif' || path === '/bob.coif') return ASSET;
  if (path.startsWith('/coif/')) return join(PACKAGE, path.slice(6));
  if (path.startsWith('/three/')) return join(HERE, 'node_modules', THREE, path.slice(7));
  return join(HERE, path);
}

let server, browser, address;
before(async () => {
  server = createServer((request, answer) => {
    const path = new URL(request.url, 'http://host').pathname;
    if (pages.has(path)) return answer.writeHead(200, { 'content-type': TYPES[extname(path)] ?? 'text/html' }).end(pages.get(path));
    const file = fileOf(path);
    if (!statSync(file, { throwIfNoEntry: false })?.isFile()) return answer.writeHead(404).end();
    answer.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' });
    return createReadStream(file).pipe(answer);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  address = `http://127.0.0.1:${server.address().port}`;
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.close();
});

/** A page, and whatever the browser complains of from now on. */
export async function open(path) {
  const page = await browser.newPage({ viewport: { width: 512, height: 512 } });
  const complaints = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto(address + path);
  return { page, complaints };
}

/** What `act` finds out in a page with a stage, and the browser's complaints. */
export async function watchStage(act, argument) {
  const { page, complaints } = await open('/scene.html');
  await page.evaluate(async () => { window.made = await window.stage; });
  const found = await page.evaluate(act, argument);
  await page.close();
  return { found, complaints };
}

/** What `act` finds out; the browser may not complain of anything. */
export async function onStage(act, argument, tolerated = /^$/) {
  const { found, complaints } = await watchStage(act, argument);
  assert.deepEqual(complaints.filter((text) => !tolerated.test(text)), [], 'the browser complains');
  return found;
}
