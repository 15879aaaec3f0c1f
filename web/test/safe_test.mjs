// A deck of anybody: what stands in its texts, names and files runs nothing, asks nobody and opens no dialog.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { address, browser, example, link, opened, settled, text } from './page.mjs';
import { examples, html, root } from './engine.mjs';

const payloads = [
  '</script><script>window.hit=1</script>', '<img src=x onerror="window.hit=1">', '<svg onload="window.hit=1"></svg>',
  '"><iframe srcdoc="<script>parent.hit=1</script>"></iframe>', "';window.hit=1;//", '<a href="javascript:window.hit=1">x</a>',
  '</style><link rel=stylesheet href=https://example.invalid/x.css>', '<math><mtext><style><img src=x onerror=window.hit=1>',
  ']]><svg xmlns="http://www.w3.org/2000/svg"><script>window.hit=1</script></svg>', '${window.hit=1}{{window.hit=1}}',
  '<img src="https://example.invalid/x.png">', '<meta http-equiv=refresh content="0;url=https://example.invalid">',
];
const all = payloads.join(' ');
const quoted = JSON.stringify;

/** Opens a link; every tab is looked at, and all that is not the page's own is noted. */
async function looked(deck) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, offline: true });
  const page = await context.newPage();
  const noted = [];
  page.on('request', (r) => /^(blob|data|file|about):/.test(r.url()) || noted.push(`asked ${r.url()}`));
  page.on('dialog', (d) => { noted.push(`dialog ${d.message()}`); void d.dismiss(); });
  page.on('popup', () => noted.push('window'));
  page.on('framenavigated', (f) => f === page.mainFrame() && !f.url().startsWith(address) && noted.push(`went to ${f.url()}`));
  await page.goto(address + link(deck));
  await page.waitForFunction(() => document.querySelector('#verdict').dataset.kind &&
    document.querySelector('#verdict').dataset.kind !== 'pending', null, { timeout: 300000 });
  for (const tab of ['checks', 'values', 'plots', 'report', 'notes']) {
    await page.click(`#choose-${tab}`);
    await page.waitForTimeout(100);
  }
  await page.locator('.cm-content').click();
  await page.keyboard.press('Control+Home');
  await page.locator('#view').selectOption('plan');
  await page.waitForTimeout(300);
  for (const frame of page.frames()) {
    assert.equal(await frame.evaluate(() => window.hit).catch(() => undefined), undefined);
    assert.equal(await frame.locator('[onerror], [onload], a[href^="javascript"], meta[http-equiv=refresh], iframe:not(#tab-report > iframe)').count(), 0);
  }
  return { page, context, noted };
}

/** A deck with payloads wherever its text may have a name. */
const hostile = (bad) => ({
  name: `${bad.replaceAll('/', '')}.yaml`,
  text: ['include: base.part.yaml', `title: ${quoted(bad)}`, `project: {project: ${quoted(bad)}, author: ${quoted(bad)}}`,
    'analyses: [{equilibrium: {}}]', 'checks: {ropes: {' + quoted('rope ' + bad) + ': {safety_factor: 3}}}', ''].join('\n'),
  files: {
    'base.part.yaml': ['taut: 1', 'machine:', `  points: {${quoted(bad)}: [0 m, 0 m, 9 m], b: [10 m, 0 m, 9 m]}`,
      `  ropes: {${quoted('rope ' + bad)}: {diameter: 10 mm, mass: 0.4 kg/m, stiffness: 5 MN, breaking_force: 60 kN}}`,
      `  reevings: [{rope: ${quoted('rope ' + bad)}, path: [{anchor: ${quoted(bad)}}, {anchor: b}], length: 10.1 m}]`, ''].join('\n'),
  },
});

for (const bad of [...payloads, all]) {
  test(`nothing runs of ${bad.slice(0, 40)}`, async () => {
    const deck = hostile(bad);
    const { page, context, noted } = await looked(deck);
    assert.equal(await text(page), deck.text);
    assert.deepEqual(noted, []);
    await context.close();
  });
}

test('a payload in plain words reaches drawing, values, plots and report as text', async () => {
  // names that taut refuses would show only in a message: this one it takes
  const bad = 'a<img src=x onerror=window.hit=1>';
  const { page, context, noted } = await looked({
    name: 'deck.yaml', files: {},
    text: readFileSync(join(root, 'examples/machines/clamped_load.yaml'), 'utf8')
      .replace(/^title: .*$/m, `title: ${quoted(bad)}`).replaceAll('skyline:', `${quoted(bad)}:`).replaceAll('skyline,', `${quoted(bad)},`),
  });
  assert.match(await page.title(), /a<img src=x/);
  assert.deepEqual(noted, []);
  await context.close();
});

test('payloads in terrain, in file names and in what is no deck', async () => {
  const own = examples().find((e) => e.name === 'machines/three_span_skyline.yaml');
  const csv = own.files['machines/three_span_skyline.csv'];
  for (const deck of [
    { ...own, files: { 'machines/three_span_skyline.csv': csv.replace(/\n/, `\n${all.replaceAll(',', '')},${all}\n`) } },
    { ...own, files: { 'machines/three_span_skyline.csv': csv.replace(/^[^\n]*/, all) } },
    { ...own, text: own.text.replace('three_span_skyline.csv', 'x<img src=y onerror=window.hit=1>.csv'),
      files: { 'machines/x<img src=y onerror=window.hit=1>.csv': csv } },
    { name: `../../${all}`, text: `include: [${payloads.map(quoted).join(', ')}]\n`, files: { '../../x.yaml': all, __proto__: 'x' } },
    { name: 'deck.yaml', text: all, files: {} },
    { name: 'deck.yaml', text: `taut: 1\n${quoted(all)}: ${quoted(all)}\nmethod: ${quoted(all)}\n`, files: {} },
    { name: 7, text: `title: ${quoted(all)}`, files: { a: 7, b: null } },
  ]) {
    const { context, noted } = await looked(deck);
    assert.deepEqual(noted, []);
    await context.close();
  }
});

test('a link that is no deck opens the first example', async () => {
  for (const hash of ['#deck=', '#deck=AAAA', '#deck=%3Cimg%20src=x%20onerror=window.hit=1%3E', '#deck=' + 'A'.repeat(9000), '#<svg onload=window.hit=1>']) {
    const { page, context, asked } = await opened(hash);
    assert.match(await text(page), /title: Running skyline/);
    assert.equal(await page.evaluate(() => window.hit), undefined);
    assert.deepEqual(asked, []);
    await context.close();
  }
});

test('included decks, terrain and CSV files travel in a link and come back', async () => {
  const { page, context } = await opened();
  const shared = async () => {
    await page.evaluate(() => {
      document.documentElement.dataset.link = '';
      navigator.clipboard.writeText = (link) => { document.documentElement.dataset.link = link; return Promise.resolve(); };
    });
    await page.click('#share');
    await page.waitForFunction(() => document.documentElement.dataset.link || document.getElementById('said').textContent);
    return page.evaluate(() => ({ link: document.documentElement.dataset.link, said: document.getElementById('said').textContent }));
  };
  // from disk there is no address: it says so
  assert.match((await shared()).said, /no web address/);
  await context.close();
  for (const name of ['machines/three_span_skyline.yaml', 'motion/rope_saw.yaml', 'study/calibrated_line.yaml']) {
    const own = examples().find((e) => e.name === name);
    assert.ok(Object.keys(own.files).length > 0, name);
    const { page: other, context: theirs } = await opened(link({ name: own.name, text: own.text, files: own.files }));
    assert.equal(await text(other), own.text);
    assert.notEqual(await other.locator('#verdict').getAttribute('data-kind'), 'bad');
    await theirs.close();
  }
});

test('what Share makes is what a link opens', async () => {
  // the same page with an address, as TAUT_WEB_ADDRESS gives it
  const place = mkdtempSync(join(tmpdir(), 'taut-'));
  const copy = join(place, 'taut.html');
  writeFileSync(copy, html().replace('data-address=""', 'data-address="https://taut.invalid/"'));
  const { page, context } = await opened('', {}, pathToFileURL(copy).href);
  rmSync(place, { recursive: true });
  await example(page, 'Three-span standing skyline, uphill');
  const own = examples().find((e) => e.name === 'machines/three_span_skyline.yaml');
  await page.evaluate(() => {
    navigator.clipboard.writeText = (link) => { document.documentElement.dataset.link = link; return Promise.resolve(); };
  });
  await page.click('#share');
  await page.waitForFunction(() => document.getElementById('said').textContent);
  const made = await page.evaluate(() => document.documentElement.dataset.link);
  assert.ok(made?.startsWith('https://taut.invalid/#deck='), await page.locator('#said').innerText());
  const { page: other, context: theirs } = await opened(made.replace('https://taut.invalid/', ''));
  assert.equal(await text(other), own.text);
  await settled(other);
  const values = (p) => p.locator('#values').evaluate((e) => e.textContent);
  assert.equal(await values(other), await values(page));
  // a browser without a clipboard: the link is to be read
  await page.evaluate(() => { Object.defineProperty(navigator, 'clipboard', { value: undefined }); });
  await page.click('#share');
  await page.waitForFunction((link) => document.getElementById('said').textContent.endsWith(link), made);
  await theirs.close();
  await context.close();
});
