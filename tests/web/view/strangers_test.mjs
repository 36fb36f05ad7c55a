// What other sites can do to a running `coif view`: nothing. node strangers_test.mjs; COIF, SOURCE, PAGE and WORK come in the
// environment, as for live_test.mjs. The strangers know the address with its token, though nobody tells them: the worst case.

import { strict as assert } from 'node:assert';
import { spawn } from 'node:child_process';
import { copyFileSync, mkdirSync, rmSync } from 'node:fs';
import { createServer, request } from 'node:http';
import { join } from 'node:path';
import { launch } from './browser.mjs';

const { COIF, SOURCE, PAGE, WORK } = process.env;
const REBOUND = 'rebound.example'; // a name of a stranger's that leads to this machine
const CHANGE = JSON.stringify({ material: { primary_exponent: 7 } });

/** The program with the sample's source: its address, and how to end it. */
async function startView() {
  copyFileSync(SOURCE, join(WORK, 'bob.glb'));
  const child = spawn(COIF, ['view', 'bob.glb', '--page', PAGE, '--format', 'json'], { cwd: WORK, stdio: ['ignore', 'pipe', 'inherit'] });
  const ended = new Promise((done) => { child.on('exit', done); });
  let text = '';
  for await (const more of child.stdout) {
    text += more;
    if (text.endsWith('}\n')) break;
  }
  return { address: JSON.parse(text).address, end: () => { child.kill('SIGTERM'); return ended; } };
}

/** A site of a stranger's, on this machine too, so that nothing but the program itself keeps it out. */
async function startSite() {
  const server = createServer((asked, answer) => answer.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html><title>stranger</title>'));
  await new Promise((done) => { server.listen(0, '127.0.0.1', done); });
  return server;
}

/** In the stranger's page: what comes of each thing it can try. */
async function attack([address, change]) {
  const outcome = (promise) => promise.then(async (response) => `${response.type} ${response.status} ${(await response.text()).length}`, () => 'refused');
  const once = (target, act) => new Promise((done) => {
    for (const name of ['load', 'error', 'message']) target.addEventListener(name, () => done(name), { once: true });
    act?.();
  });
  const element = (name, attributes) => {
    const made = Object.assign(document.createElement(name), attributes);
    return once(made, () => document.body.append(made));
  };
  const found = {
    page: await outcome(fetch(address)),
    asset: await outcome(fetch(`${address}asset`)),
    unseen: await outcome(fetch(`${address}asset`, { mode: 'no-cors' })),
    post: await outcome(fetch(`${address}recipe`, { method: 'POST', body: change })),
    unseenPost: await outcome(fetch(`${address}recipe`, { method: 'POST', mode: 'no-cors', body: change })),
    model: await outcome(fetch(`${address}model?format=glb&name=x.glb`, { method: 'POST', mode: 'no-cors', body: change })),
    events: await once(new EventSource(`${address}events`)),
    script: await element('script', { src: address }),
    image: await element('img', { src: `${address}asset` }),
  };
  const form = Object.assign(document.createElement('form'), { method: 'POST', enctype: 'text/plain', action: `${address}recipe`, target: 'inside' });
  const field = Object.assign(document.createElement('input'), { name: change.slice(0, -1), value: '}' });
  const inside = Object.assign(document.createElement('iframe'), { name: 'inside' });
  form.append(field);
  document.body.append(inside, form);
  await once(inside, () => form.submit());
  const opened = window.open(address);
  found.window = 'never comes';
  for (const end = Date.now() + 60_000; Date.now() < end; await new Promise((done) => { setTimeout(done, 50); })) {
    try {
      if (opened === null || opened.closed) found.window = 'refused';
      else if (opened.coif !== undefined) found.window = 'seen';
    } catch {
      found.window = 'refused';
    }
    if (found.window !== 'never comes') break; // until it has loaded it is the stranger's own empty page
  }
  return found;
}

/** The status that a request of a program without a browser's manners gets. */
function statusOf(address, { path, headers = {}, method = 'GET', body = '' }) {
  const { hostname, port } = new URL(address);
  return new Promise((done, failed) => {
    const asked = request({ hostname, port, path, method, headers }, (answer) => { answer.resume(); done(answer.statusCode); });
    asked.on('error', failed);
    asked.end(body);
  });
}

async function ruderRequests(address) {
  const { host, pathname, port } = new URL(address);
  const post = { path: `${pathname}recipe`, method: 'POST', body: CHANGE };
  const refused = {
    'no token': { path: '/asset' },
    'another token': { path: `/${'0'.repeat(32)}/asset` },
    'another Host': { path: pathname, headers: { host: `${REBOUND}:${port}` } },
    'no port': { path: pathname, headers: { host: '127.0.0.1' } },
    'another Origin': { ...post, headers: { origin: `http://${REBOUND}` } },
    'an Origin without a name': { ...post, headers: { origin: 'null' } },
    'a file beside the page': { path: `${pathname}../bob.glb` },
  };
  for (const [what, asked] of Object.entries(refused)) {
    const status = await statusOf(address, asked);
    assert.ok(status === 403 || status === 404, `${what}: ${status}`);
  }
  assert.equal(await statusOf(address, { path: pathname, headers: { host } }), 200, 'its own page is refused as well');
}

const changesOf = (page) => page.evaluate(async () => {
  const { live } = await window.coif;
  return JSON.stringify([live.revision, live.state.changes]);
});

rmSync(WORK, { recursive: true, force: true });
mkdirSync(WORK, { recursive: true });
const view = await startView();
const site = await startSite();
const browser = await launch([`--host-resolver-rules=MAP ${REBOUND} 127.0.0.1`]);
try {
  const own = await (await browser.newContext()).newPage();
  await own.goto(view.address);
  const before = await changesOf(own);

  const stranger = await (await browser.newContext()).newPage();
  for (const host of ['127.0.0.1', 'localhost', REBOUND]) {
    await stranger.goto(`http://${host}:${site.address().port}/`);
    const found = await stranger.evaluate(attack, [view.address, CHANGE]);
    console.log(host, JSON.stringify(found));
    const expected = Object.fromEntries(Object.keys(found).map((name) => [name, ['events', 'script', 'image'].includes(name) ? 'error' : 'refused']));
    // A request whose answer nobody may see is sent all the same; what counts is below.
    assert.deepEqual({ ...found, unseenPost: 'refused', model: 'refused' }, expected, host);
  }
  const rebound = view.address.replace('127.0.0.1', REBOUND);
  const answered = stranger.waitForEvent('response', (response) => response.url() === rebound);
  await stranger.goto(rebound).catch(() => {}); // an answer without a body is an error of the browser's
  assert.equal((await answered).status(), 403, `${rebound} is admitted`);
  await ruderRequests(view.address);

  await new Promise((done) => { setTimeout(done, 1000); }); // what somebody had changed would be cooking by now
  assert.equal(await changesOf(own), before, 'a stranger has changed the hair');
} finally {
  await browser.close();
  site.close();
  assert.equal(await view.end(), 0);
}
