// Print of the page is the report in full: title, verdict, figures, and no control of the page.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { example, opened, text, verdict, write } from './page.mjs';

/** Pages and text of a PDF, by poppler. */
async function printed(page) {
  const place = mkdtempSync(join(tmpdir(), 'taut-'));
  try {
    const file = join(place, 'page.pdf');
    await page.emulateMedia({ media: 'print' });
    await page.pdf({ path: file, preferCSSPageSize: true, printBackground: true });
    const out = (program, ...args) => execFileSync(program, [...args, file], { encoding: 'utf8' });
    const pages = Number(/Pages:\s+(\d+)/.exec(out('pdfinfo'))[1]);
    return { pages, words: execFileSync('pdftotext', ['-raw', file, '-'], { encoding: 'utf8' }) };
  } finally {
    rmSync(place, { recursive: true });
  }
}

/** The window that the button Print, or Ctrl P, opens and would print. */
async function report(page, context, byKey) {
  await page.click('#choose-report');
  await page.waitForSelector('iframe');
  const window = context.waitForEvent('page');
  if (byKey) await page.keyboard.press('Control+p');
  else await page.getByRole('button', { name: 'Print' }).click();
  const other = await window;
  await other.waitForLoadState();
  return other;
}

for (const [title, byKey] of [['Running skyline', false], ['Three-span standing skyline, uphill', true]]) {
  test(`the report of ${title} prints in full${byKey ? ', by Ctrl P' : ''}`, async () => {
    const { page, context } = await opened();
    await context.addInitScript(() => { window.print = () => {}; });
    await example(page, title);
    const other = await report(page, context, byKey);
    const figures = await other.locator('svg').count();
    assert.ok(figures > 2);
    const { pages, words } = await printed(other);
    assert.ok(pages > 1, `${pages} pages`);
    assert.ok(words.includes(title));
    assert.match(words, /Passes, with warnings|Passes|Fails/);
    // what the report itself keeps folded is folded on paper, too
    const captions = await other.locator('figcaption').evaluateAll((all) =>
      all.filter((c) => c.getClientRects().length > 0).map((c) => c.innerText));
    assert.ok(captions.length > 2);
    const flat = words.replace(/\s+/g, ' ');
    for (const caption of captions) assert.ok(flat.includes(caption.trim().replace(/\s+/g, ' ').slice(0, 30)), caption);
    assert.doesNotMatch(words, /Save report|Share|Answer +Checks/);
    await context.close();
  });
}

test('the page itself prints what it shows, without its controls', async () => {
  const { page, context } = await opened();
  const { words } = await printed(page);
  assert.match(words, /Passes, with warnings/);
  assert.match(words, /safety factor/i);
  for (const control of ['Share', 'Open', 'Save', 'Example', 'Play', 'View']) assert.doesNotMatch(words, new RegExp(`^${control}\\b`, 'm'));
  await context.close();
});

test('of a deck that has changed since, its own mistake is printed, and nothing while it is calculated', async () => {
  const { page, context } = await opened();
  await context.addInitScript(() => { window.print = () => {}; });
  await page.click('#choose-report');
  await page.waitForSelector('iframe');
  const deck = await text(page);
  await write(page, deck.replace('mass: 900 kg', 'mass: 900 kgg'));
  await page.waitForSelector('.error', { state: 'attached' });
  for (const byKey of [false, true]) {
    const window = context.waitForEvent('page');
    if (byKey) await page.keyboard.press('Control+p');
    else await page.getByRole('button', { name: 'Print' }).click();
    const words = await (await window).locator('body').innerText();
    assert.match(words, /kgg/);
    assert.doesNotMatch(words, /Passes/);
  }
  // the browser's own print has the mistake too, and nothing of the deck before
  const { words } = await printed(page);
  assert.match(words, /kgg/);
  assert.doesNotMatch(words, /Passes|safety factor/i);
  await page.emulateMedia({ media: 'screen' });
  await write(page, deck.replaceAll('steps: 70', 'steps: 7000'));
  await page.getByRole('button', { name: 'Print' }).click();
  await page.waitForFunction(() => /no answer yet/.test(document.getElementById('said').textContent));
  assert.equal(context.pages().length, 3);
  await context.close();
});

test('after Stop no tab is blank, nothing throws, and what is printed is not of the deck before', async () => {
  for (const withOld of [false, true]) {
    const { page, context, said } = await opened();
    await example(page, 'A skyline that takes its load at once');
    if (withOld) {
      await page.click('#choose-report');
      await page.waitForSelector('iframe');
      await write(page, (await text(page)).replace('duration: 6 s', 'duration: 600 s'));
    } else {
      await page.locator('#examples').selectOption({ label: 'Telescopic boom, extension rope broken at 17 m, hook' });
    }
    await page.locator('#stop').click({ timeout: 60000 });
    await page.waitForFunction(() => document.querySelector('#verdict').innerText.includes('Stopped'));
    for (const tab of ['plots', 'report']) {
      await page.click(`#choose-${tab}`);
      await page.waitForTimeout(500);
      assert.ok((await page.locator(`#tab-${tab}`).innerHTML()).length > 60, tab);
      if (!withOld) assert.match(await page.locator(`#tab-${tab}`).innerText(), /come|comes with the answer/);
    }
    await page.keyboard.press('Control+p');
    await page.waitForFunction(() => /no answer yet/.test(document.getElementById('said').textContent));
    assert.equal(context.pages().length, 1);
    assert.doesNotMatch(await verdict(page), /Passes/);
    assert.deepEqual(said.filter((s) => !/sandboxed|inline style/.test(s)), []);
    await context.close();
  }
});
