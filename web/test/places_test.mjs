// What a handle writes stands where its number stands, or nothing is written: however fast a hand is, and whatever the
// deck is meanwhile.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { link, opened, settled, text, write } from './page.mjs';
import { root } from './engine.mjs';

const drop = readFileSync(join(root, 'examples/motion/skyline_load_drop.yaml'), 'utf8');
/** A motion that is solved for about a second. */
const slow = drop.replace('duration: 6 s', 'duration: 20 s').replace('1e-3', '1e-5').replace('0 m, 12 m]', '0 m, 7 m]');
const of = (deck) => link({ name: 'deck.yaml', text: deck, files: {} });

const centre = async (page, path) => {
  const box = await page.locator(`.handle[data-path="${path}"]`).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};

/** The line that a handle's numbers stand on. */
function lineOf(path) {
  const load = path.includes('.loads[');
  if (load) return /^ +- \{at: car, mass: /;
  return new RegExp(`^ +${path.split('.')[2]}: `);
}

/** Both texts without the three numbers of a place, or the number of a load, on the lines that the handle may write. */
function sameBut(path, before, after) {
  const number = /(at: |^ +\w+: )\[[^\]]*\]|mass: [-\d.]+ kg\}/g;
  const bare = (deck) => deck.split('\n')
    .map((line) => lineOf(path).test(line) ? line.replace(number, '$1') : line).join('\n');
  assert.equal(bare(after), bare(before), path);
  const units = (deck) => deck.match(/[-\d.e]+ (m|kg|kN)\b/g).length;
  assert.equal(units(after), units(before), path);
}

/** Numbers from 0 to 1, the same in each run. */
function* chance(seed) {
  for (let x = seed; ; ) {
    x = (Math.imul(x, 1664525) + 1013904223) >>> 0;
    yield x / 2 ** 32;
  }
}

for (const [seed, deck] of [[1, undefined], [3, slow], [4, slow]]) {
  test(`drags and keys in quick succession change their own numbers only (${seed})`, async () => {
    const { page, context, said } = await opened(deck ? of(deck) : '');
    await page.evaluate(() => addEventListener('pointerdown', (e) => {
      document.body.dataset.hit = e.target.dataset?.path ?? '';
    }, true));
    const dice = chance(seed);
    const next = (n) => Math.floor(dice.next().value * n);
    const drag = async (path) => {
      const [x, y] = await centre(page, path);
      const [right, down] = [next(50) - 25, next(50) - 25];
      await page.mouse.move(x, y);
      await page.mouse.down();
      for (let i = 1; i <= 4; ++i) {
        await page.mouse.move(x + (right * i) / 4, y + (down * i) / 4);
        await page.waitForTimeout(next(90));
      }
      await page.mouse.up();
      // another one may lie above it
      return page.evaluate(() => document.body.dataset.hit);
    };
    const press = async (path) => {
      await page.locator(`.handle[data-path="${path}"]`).focus();
      for (let i = next(4); i >= 0; --i) {
        await page.keyboard.press(`${next(2) ? 'Shift+' : ''}Arrow${['Up', 'Down', 'Left', 'Right'][next(4)]}`);
      }
      return path;
    };
    let written = 0;
    for (let i = 0; i < 30; ++i) {
      const paths = await page.locator('.handle:visible').evaluateAll((all) => all.map((h) => h.dataset.path));
      const path = paths.filter((p) => !p.startsWith('analyses'))[next(paths.length)];
      if (!path) continue;
      const before = await text(page);
      const moved = await (next(2) ? drag(path) : press(path));
      const after = await text(page);
      if (moved) sameBut(moved, before, after);
      else assert.equal(after, before);
      if (after !== before) ++written;
      await page.waitForTimeout(next(2) * next(400));
    }
    assert.ok(written > 12, `${written} written`);
    await settled(page);
    assert.deepEqual(said, []);
    await context.close();
  });
}

test('a second drag, before the answer of the first one or as it comes, writes its own number', async () => {
  const { page, context } = await opened(of(slow));
  const before = await text(page);
  let [x, y] = await centre(page, 'machine.points.head');
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 30; ++i) {
    await page.mouse.move(x, y - i);
    await page.waitForTimeout(60);
  }
  await page.mouse.up();
  const first = await text(page);
  assert.match(first, /head: \[0 m, 0 m, \d\d(\.\d+)? m\]/);
  [x, y] = await centre(page, 'machine.points.tail');
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) {
    await page.mouse.move(x, y - 3 * i);
    await page.waitForTimeout(150);
  }
  await page.mouse.up();
  const second = await text(page);
  const tail = /tail: \[120 m, 0 m, (\S+) m\]/.exec(second)[1];
  assert.ok(Number(tail) > 20, tail);
  assert.equal(second.replace(`tail: [120 m, 0 m, ${tail} m]`, 'tail: [120 m, 0 m, 20 m]'), first);
  sameBut('machine.points.head', before, first);
  await context.close();
});

test('a deck with a mistake has no handles, and they come back with the next answer', async () => {
  const { page, context } = await opened(of(drop));
  const handle = page.locator('.handle[data-path="machine.points.tree"]');
  const [x, y] = await centre(page, 'machine.points.tree');
  const lines = drop.split('\n');
  const tree = lines.findIndex((l) => l.includes('tree: ['));
  [lines[tree - 1], lines[tree]] = [lines[tree], lines[tree - 1]];
  const bad = lines.join('\n').replace('mass: 1.2 t', 'mass: 1.2 tt');
  await write(page, bad);
  await page.waitForSelector('.error');
  assert.ok(await handle.isHidden());
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y + 20);
  await page.mouse.up();
  await page.waitForTimeout(300);
  assert.equal(await text(page), bad);
  await write(page, bad.replace('1.2 tt', '1.2 t'));
  await settled(page);
  await handle.focus();
  await page.keyboard.press('ArrowUp');
  sameBut('machine.points.tree', bad.replace('1.2 tt', '1.2 t'), await text(page));
  assert.doesNotMatch(await text(page), /tree: \[60 m, 0 m, 24 m\]/);
  await context.close();
});

test('the handles of a machine go with it', async () => {
  const { page, context } = await opened();
  assert.ok(await page.locator('.handle:visible').count() > 3);
  await page.locator('#examples').selectOption({ label: 'Telescopic boom, extension rope broken at 17 m, hook' });
  assert.equal(await page.locator('.handle:visible').count(), 0);
  await page.waitForSelector('#verdict[data-kind="pending"]', { timeout: 60000 });
  assert.equal(await page.locator('.handle:visible').count(), 0);
  await context.close();
});
