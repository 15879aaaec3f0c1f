// The page in Firefox, opened from disk: a browser of another make, driven over WebDriver BiDi.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import puppeteer from 'puppeteer-core';
import { address, pictures } from './page.mjs';

let browser;
before(async () => {
  browser = await puppeteer.launch({
    browser: 'firefox', executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr', headless: true,
    // nothing of the network is there to be asked, and the browser itself asks nobody
    extraPrefsFirefox: {
      'network.proxy.type': 1, 'network.proxy.http': '127.0.0.1', 'network.proxy.http_port': 9, 'network.proxy.ssl': '127.0.0.1',
      'network.proxy.ssl_port': 9, 'network.proxy.allow_hijacking_localhost': true, 'network.dns.disabled': true,
    },
  });
});
after(() => browser?.close());

const settled = (page) => page.waitForFunction(() => document.getElementById('took').textContent !== '' &&
  !document.getElementById('machine').classList.contains('old'), { timeout: 300000 });
const text = (page) => page.evaluate(() => document.querySelector('.cm-content').cmTile?.view?.state.doc.toString() ??
  document.querySelector('.cm-content').cmView.view.state.doc.toString());

test('Firefox opens the page from disk without a network, solves, drags and shows every tab', async () => {
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 800 });
  const said = [];
  const asked = [];
  page.on('console', (m) => m.type() === 'error' && said.push(m.text()));
  page.on('pageerror', (e) => said.push(e.message));
  page.on('request', (r) => /^(blob|data|file):/.test(r.url()) || asked.push(r.url()));
  await page.goto(address);
  await settled(page);
  const verdict = () => page.$eval('#verdict', (e) => e.innerText);
  assert.match(await verdict(), /Passes, with warnings/);

  const before = await text(page);
  const box = await (await page.$('.handle[data-path="machine.sheaves.tail_block.at"]')).boundingBox();
  await page.mouse.move(box.x + 12, box.y + 12);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) await page.mouse.move(box.x + 12, box.y + 12 + 4 * i);
  await page.mouse.up();
  await settled(page);
  const at = /tail_block: \{at: \[(.*?)\]/.exec(await text(page))[1].split(', ');
  assert.equal(at[0], '200 m');
  assert.ok(parseFloat(at[2]) < 40, at[2]);
  await page.focus('.cm-content');
  for (let i = 0; i < 20 && (await text(page)) !== before; ++i) {
    await page.keyboard.down('Control');
    await page.keyboard.press('z');
    await page.keyboard.up('Control');
  }
  assert.equal(await text(page), before);

  const example = async (title) => {
    await page.evaluate(() => { document.getElementById('took').textContent = ''; });
    const value = await page.$$eval('#examples option', (all, wanted) => all.find((o) => o.textContent === wanted).value, title);
    await page.select('#examples', value);
    await settled(page);
  };
  await example('Three-span standing skyline, uphill');
  assert.match(await verdict(), /Passes|Fails/);
  for (const tab of ['checks', 'values', 'plots', 'report']) {
    await page.click(`#choose-${tab}`);
    assert.ok((await page.$eval(`#tab-${tab}`, (e) => e.getBoundingClientRect().height)) > 50, tab);
  }
  await page.waitForSelector('iframe');
  await page.screenshot({ path: join(pictures, 'firefox-light-1280.png') });
  await page.click('#choose-checks');
  assert.ok((await page.$$eval('#checks tbody tr', (all) => all.length)) > 3);
  // the policy keeps a script out of the report's frame: the browser may say so
  assert.deepEqual(said.filter((s) => !/sandbox|Content-Security-Policy/i.test(s)), []);
  assert.deepEqual(asked, []);
  await page.close();
});
