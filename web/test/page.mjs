// The page in Chromium, opened from disk, with the network off: what the tests of the page share.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { address, launched, settled } from './chromium.mjs';
import { root } from './engine.mjs';

export { address, settled };
export const pictures = join(root, 'build-web/screenshots');
mkdirSync(pictures, { recursive: true });
export let browser;

before(async () => {
  browser = await launched();
});
after(() => browser?.close());

/** A page with the network off that has solved its first deck; what it asks for and complains of is kept. `meanwhile`:
    what is done before that. */
export async function opened(hash = '', options = {}, from = address, meanwhile = async () => {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, offline: true, ...options });
  const page = await context.newPage();
  const asked = [];
  const said = [];
  page.on('request', (r) => /^(blob|data|file):/.test(r.url()) || asked.push(r.url()));
  page.on('console', (m) => m.type() === 'error' && said.push(m.text()));
  page.on('pageerror', (e) => said.push(e.stack ?? e.message));
  await page.goto(from + hash);
  await meanwhile(page);
  await settled(page);
  return { page, context, asked, said };
}
export const text = (page) => page.evaluate(() => document.querySelector('.cm-content').cmTile?.view?.state.doc.toString() ??
  document.querySelector('.cm-content').cmView.view.state.doc.toString());
export const verdict = (page) => page.locator('#verdict').innerText();

export async function write(page, deck) {
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(deck);
  await page.waitForTimeout(50);
}
export async function example(page, title) {
  await page.evaluate(() => { document.getElementById('took').textContent = ''; });
  await page.locator('#examples').selectOption({ label: title });
  await settled(page);
}

/** A deck as a link has it. */
export const link = (deck) => '#deck=' + deflateRawSync(JSON.stringify(deck)).toString('base64url');
