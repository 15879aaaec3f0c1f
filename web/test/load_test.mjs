// The page of a web space while its engine still loads.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { test } from 'node:test';
import { root } from './engine.mjs';
import { opened, settled, text, verdict } from './page.mjs';

const types = { '.wasm': 'application/wasm', '.js': 'text/javascript', '.css': 'text/css', '.html': 'text/html' };

/** The site at an address of its own; the engine comes when `sent` is called. */
async function slowSite() {
  let send;
  const free = new Promise((resolve) => { send = resolve; });
  let engines = 0;
  const server = createServer(async (request, response) => {
    const name = new URL(request.url, 'http://a').pathname.slice(1) || 'index.html';
    if (name.endsWith('.wasm')) {
      ++engines;
      await free;
    }
    if (!types[extname(name)]) return response.writeHead(404).end();
    response.writeHead(200, { 'Content-Type': types[extname(name)] });
    response.end(readFileSync(join(root, 'build-web/page/site', name)));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, send, engines: () => engines, close: () => server.close() };
}

test('a deck that changes while the engine loads is solved when it is there, and the engine is loaded once', async () => {
  const site = await slowSite();
  try {
    const { page, context, said } = await opened('', { offline: false }, site.address, async (page) => {
      await page.waitForFunction(() => /title: Running skyline/.test(document.querySelector('.cm-content').innerText));
      for (const key of ['x', 'y']) {
        await page.locator('.cm-content').click();
        await page.keyboard.press('Control+End');
        await page.keyboard.type(`# ${key}`);
        // longer than a calculation is waited for
        await page.waitForTimeout(2000);
      }
      site.send();
    });
    assert.match(await verdict(page), /Passes/);
    assert.match(await text(page), /# x# y$/);
    assert.equal(site.engines(), 1);
    await page.locator('#examples').selectOption({ label: 'Single span with a clamped load' });
    await page.waitForFunction(() => /Single span/.test(document.title));
    await settled(page);
    assert.deepEqual(said, []);
    await context.close();
  } finally {
    site.close();
  }
});
