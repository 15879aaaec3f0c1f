// Print of the page is the report in full: title, verdict, figures, and no control of the page.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { example, opened } from './page.mjs';

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
