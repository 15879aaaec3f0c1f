// Every example as a reader opens it in the page: verdict, warnings and checks of the native program, and no error of the page.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { opened } from './page.mjs';
import { examples, isMotion, native } from './engine.mjs';

/** Motions that are solved here, too; each of the others takes longer than all of these, and engine_test compares them. */
const motions = ['motion/skyline_load_drop.yaml', 'motion/brake_stop.yaml', 'motion/tackle_hoist.yaml'];

let shown;
after(() => shown?.context.close());

examples().forEach((deck, index) => {
  if (isMotion(deck) && !motions.includes(deck.name)) return;
  test(`${deck.name} in the page is that of the program`, async () => {
    shown ??= await opened();
    const { page, said } = shown;
    const theirs = JSON.parse(native(deck, '-q', '--json'));
    await page.click('#choose-notes');
    await page.evaluate(() => { document.getElementById('took').textContent = ''; });
    await page.locator('#examples').selectOption(String(index));
    await page.waitForFunction(() => document.getElementById('took').textContent || document.getElementById('verdict').dataset.kind === 'bad',
      null, { timeout: 600000 });
    assert.equal(await page.locator('.error').count(), 0);
    assert.equal(await page.locator('#verdict').getAttribute('data-kind'), theirs.verdict);
    const strip = (text) => text.replace(/[-−]?\d+(\.\d+)?([eE][-+]?\d+)?/g, '#').replace(/\s+/g, ' ').trim();
    const warnings = await page.locator('#notes p.warning, #notes p.unsafe').evaluateAll((all) => all.map((p) => p.textContent));
    assert.deepEqual(warnings.map(strip).sort(), theirs.warnings.map(strip).sort());
    // the numbers are compared in engine_test; here, that the page shows them
    const reason = await page.locator('#verdict span').allInnerTexts();
    const same = isMotion(deck) ? strip : (text) => text;
    assert.equal(same(reason.join('')), same(theirs.verdict_reason || theirs.message));
    const names = await page.locator('#values tbody td.rule').evaluateAll((all) => all.map((e) => e.textContent));
    assert.deepEqual(names.filter((n) => !(n in theirs.values)), []);
    assert.ok(names.length > 0 || Object.keys(theirs.values).length === 0);
    const failed = await page.locator('#checks tr.fails').count();
    assert.equal(failed > 0, theirs.checks.some((c) => c.passes === false));
    // plots, report and pictures are made without an error
    await page.click('#choose-plots');
    await page.click('#choose-report');
    await page.locator('#tab-report iframe').waitFor({ timeout: 300000 });
    assert.deepEqual(said.splice(0).filter((s) => !/sandboxed/.test(s)), []);
  });
});
