// A deck with several motions: each has its own picture, slider, events and plots.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from './engine.mjs';
import { link, opened } from './page.mjs';

const drop = readFileSync(join(root, 'examples/motion/skyline_load_drop.yaml'), 'utf8');
const transient = /^ {2}- transient: .*$/m;
const two = drop.replace(transient, `  - transient: {name: quick, duration: 0.5 s, output_step: 10 ms, tolerance: 1e-3}
  - transient: {name: long, duration: 6 s, output_step: 10 ms, tolerance: 1e-3}`);
const of = (text) => link({ name: 'deck.yaml', text, files: {} });

const now = (page) => page.locator('#now').innerText();
/** The events that the slider passes. */
const events = (page) => page.evaluate(() => {
  const time = document.getElementById('time');
  const all = new Set();
  for (let i = 0; i <= Number(time.max); ++i) {
    time.value = i;
    time.dispatchEvent(new Event('input'));
    all.add(document.getElementById('event').textContent);
  }
  all.delete('');
  return [...all];
});
/** Points at a share of the width of the plot of forces of a motion. */
async function hover(page, share, title) {
  const over = page.locator('#plots figure', { hasText: title }).locator('.u-over');
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + box.width * share, box.y + 50);
  await page.mouse.move(box.x + box.width * share + 1, box.y + 50);
  await page.waitForTimeout(200);
}

test('each of two motions is chosen, with its own times and events, and moved by its own plots alone', async () => {
  const { page, context, said } = await opened(of(two));
  const motion = page.locator('#motion');
  assert.deepEqual(await motion.locator('option').allInnerTexts(), ['quick', 'long']);
  assert.equal(await motion.inputValue(), 'motion_quick');
  assert.deepEqual(await events(page), []);
  assert.equal(await now(page), '0.5 s');
  await page.click('#choose-plots');
  await hover(page, 0.6, 'force, long');
  assert.equal(await now(page), '0.5 s');
  await hover(page, 0.6, 'force, quick');
  assert.match(await now(page), /^0\.[23]\d* s$/);
  await motion.selectOption('motion_long');
  assert.equal(await now(page), '0 s');
  const all = await events(page);
  assert.ok(all.includes('break strop'), all.join());
  assert.equal(await now(page), '6 s');
  await hover(page, 0.6, 'force, quick');
  assert.equal(await now(page), '6 s');
  await hover(page, 0.6, 'force, long');
  assert.match(await now(page), /^3\.\d+ s$/);
  // the next answer shows the same motion again
  await page.locator('.handle[data-path="machine.points.tree"]').focus();
  await page.keyboard.press('ArrowUp');
  await page.waitForFunction(() => document.getElementById('now').textContent === '0 s');
  assert.equal(await motion.inputValue(), 'motion_long');
  assert.deepEqual(said, []);
  await context.close();
});

test('a single motion needs no choice, and its plots in minutes follow its seconds', async () => {
  const { page, context } = await opened(of(drop.replace('machine:', 'display: {time: min}\nmachine:')));
  assert.ok(await page.locator('#player').isVisible());
  assert.ok(await page.locator('#motions').isHidden());
  await page.click('#choose-plots');
  await hover(page, 0.5, 'force');
  const share = await page.evaluate(() => document.getElementById('time').value / document.getElementById('time').max);
  assert.ok(Math.abs(share - 0.5) < 0.1, `${share}`);
  await page.mouse.move(5, 5);
  await page.locator('#time').focus();
  await page.keyboard.press('End');
  await page.waitForTimeout(200);
  // the cursor of the plot stands at its right end
  const [x, right] = await page.locator('#plots figure', { hasText: 'force' }).first().evaluate((figure) => {
    const line = figure.querySelector('.u-cursor-x').getBoundingClientRect();
    return [line.left, figure.querySelector('.u-over').getBoundingClientRect().right];
  });
  assert.ok(Math.abs(x - right) < 5, `${x} of ${right}`);
  await context.close();
});
