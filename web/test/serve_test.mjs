// The page in Chromium as `taut serve` sends it: the program calculates.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { launched, settled } from './chromium.mjs';
import { root } from './engine.mjs';

const program = process.env.TAUT_PROGRAM ?? join(root, 'build/bin/taut');
const site = process.env.TAUT_PAGE ?? join(root, 'build-web/page');
const pictures = join(root, 'build-web/screenshots');
mkdirSync(pictures, { recursive: true });
const patience = { timeout: 300000 };

const mast = readFileSync(join(root, 'examples/mast_section.yaml'), 'utf8');
const endless = readFileSync(join(root, 'test/program/serve_test.py'), 'utf8').split('ENDLESS = """')[1].split('"""')[0];

let browser, folder, server, address;
before(async () => {
  browser = await launched();
});
after(() => browser?.close());
beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), 'taut-'));
  mkdirSync(join(folder, 'lines'));
  writeFileSync(join(folder, 'mast.part.yaml'), mast);
  writeFileSync(join(folder, 'lines/mast.yaml'), 'include: ../mast.part.yaml\ntitle: A mast of the folder\n');
  writeFileSync(join(folder, 'endless.yaml'), endless);
  server = spawn(program, ['serve', folder, '--page', site], { stdio: ['ignore', 'pipe', 'ignore'] });
  [address] = await createInterface({ input: server.stdout })[Symbol.asyncIterator]().next().then((line) => [line.value]);
});
afterEach(async () => {
  const ended = new Promise((resolve) => server.once('exit', resolve));
  server.kill('SIGINT');
  assert.equal(await ended, 0);
  rmSync(folder, { recursive: true });
});

/** A page of the server; what it complains of is kept. */
async function opened(context) {
  const page = await context.newPage();
  page.said = [];
  page.on('console', (m) => m.type() === 'error' && page.said.push(m.text()));
  page.on('pageerror', (e) => page.said.push(e.message));
  await page.goto(address);
  return page;
}
const titled = (page, title) => page.waitForFunction((t) => document.title.startsWith(t), title, patience);
const working = (page) => page.waitForFunction(() => !document.getElementById('working').hidden &&
  document.getElementById('done').value > 0, null, patience);
async function choose(page, name) {
  await page.locator('#files').focus();
  await page.waitForFunction((n) => [...document.getElementById('files').options].some((o) => o.value === n), name, patience);
  await page.locator('#files').selectOption(name);
}

test('the program answers the page, the report included', async () => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  const page = await opened(context);
  await settled(page);
  assert.match(await page.locator('#verdict').innerText(), /Passes, with warnings/);
  await page.click('#choose-plots');
  await page.waitForSelector('#figures img', patience);
  await page.screenshot({ path: join(pictures, 'served-1280.png') });
  assert.deepEqual(page.said, []);
  await page.click('#choose-report');
  await page.frameLocator('#tab-report iframe').locator('h1, h2').first().waitFor(patience);
  assert.equal(await page.evaluate(() => typeof Worker !== 'undefined' && performance.getEntriesByType('resource').some((r) => r.name.includes('wasm'))), false);
  await context.close();
});

test('decks of the folder are opened with what they name, and saved', async () => {
  const context = await browser.newContext();
  const page = await opened(context);
  await settled(page);
  await choose(page, 'lines/mast.yaml');
  await titled(page, 'A mast of the folder');
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('# written by the page\n');
  await page.click('#save');
  await page.waitForFunction(() => document.getElementById('said').textContent === 'Saved lines/mast.yaml.', null, patience);
  assert.equal(readFileSync(join(folder, 'lines/mast.yaml'), 'utf8'),
    'include: ../mast.part.yaml\ntitle: A mast of the folder\n# written by the page\n');
  page.once('dialog', (dialog) => dialog.accept('../out.yaml'));
  await page.locator('#examples').selectOption({ index: 2 });
  await page.click('#save');
  await page.waitForFunction(() => document.getElementById('said').textContent.includes('outside the folder'), null, patience);
  await context.close();
});

test('a long calculation outlives its page, and Stop gives what is done', async () => {
  const context = await browser.newContext();
  let page = await opened(context);
  await settled(page);
  await choose(page, 'endless.yaml');
  await working(page);
  const before = await page.evaluate(() => document.getElementById('done').value);
  await page.reload();
  await working(page);
  assert.ok(await page.evaluate(() => document.getElementById('done').value) >= before, 'the same job goes on');
  await page.close();
  page = await opened(context); // another tab, later
  await working(page);
  assert.ok(await page.evaluate(() => document.getElementById('done').value) >= before);
  assert.equal(await page.locator('#deck-name').innerText(), 'endless.yaml');
  await page.click('#stop');
  await titled(page, 'A load that goes up and down');
  assert.match(await page.locator('#notes').innerText(), /interrupted at t =/);
  assert.ok(await page.evaluate(() => Number(document.getElementById('time').max)) > 1);
  assert.equal(await page.locator('#working').isVisible(), false);
  assert.deepEqual(page.said, []);
  await context.close();
});

test('a change of the deck ends its long calculation', async () => {
  const context = await browser.newContext();
  const page = await opened(context);
  await settled(page);
  await choose(page, 'endless.yaml');
  await working(page);
  await choose(page, 'lines/mast.yaml');
  await titled(page, 'A mast of the folder');
  const jobs = await page.evaluate(async () => (await (await fetch(`api/jobs${location.search}`)).json()).jobs);
  assert.deepEqual(jobs.filter((j) => j.name === 'endless.yaml'), []);
  await context.close();
});

test('without the program the page says so', async () => {
  const context = await browser.newContext();
  const page = await opened(context);
  await settled(page);
  server.kill('SIGINT');
  await new Promise((resolve) => server.once('exit', resolve));
  await page.locator('.cm-content').click();
  await page.keyboard.insertText('# more\n');
  await page.waitForFunction(() => document.getElementById('verdict').textContent.includes('is it still running?'), null, patience);
  await context.close();
  server = { once: (_, resolve) => resolve(0), kill: () => {} };
});
