// The page in Chromium, opened from disk, with the network off.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { example, opened, pictures, settled, text, verdict, write } from './page.mjs';

test('it opens from disk without a network and asks nobody', async () => {
  const { page, context, asked, said } = await opened();
  assert.match(await verdict(page), /Passes, with warnings/);
  assert.deepEqual(asked, []);
  assert.deepEqual(said, []);
  await page.screenshot({ path: join(pictures, 'start-light-1280.png') });
  await page.click('#theme');
  await page.screenshot({ path: join(pictures, 'start-dark-1280.png') });
  for (const tab of ['checks', 'values', 'plots']) {
    await page.click(`#choose-${tab}`);
    await page.screenshot({ path: join(pictures, `${tab}-dark-1280.png`) });
  }
  assert.ok((await page.locator('#checks tbody tr').count()) > 3);
  await context.close();
});

test('a drag writes the number into the deck, keeps comments, and undo takes it back', async () => {
  const { page, context, said } = await opened();
  const before = await text(page);
  const handle = page.locator('.handle[data-path="machine.sheaves.tail_block.at"]');
  const box = await handle.boundingBox();
  await page.mouse.move(box.x + 12, box.y + 12);
  await page.mouse.down();
  for (let i = 1; i <= 10; ++i) await page.mouse.move(box.x + 12, box.y + 12 + 4 * i);
  await page.mouse.up();
  await settled(page);
  const moved = await text(page);
  assert.notEqual(moved, before);
  const at = /tail_block: \{at: \[(.*?)\]/.exec(moved)[1].split(', ');
  assert.equal(at[0], '200 m');
  assert.ok(parseFloat(at[2]) < 40, at[2]);
  assert.equal(moved.replace(/tail_block: \{at: \[.*?\]/, ''), before.replace(/tail_block: \{at: \[.*?\]/, ''));
  await page.locator('.cm-content').focus();
  for (let i = 0; i < 20 && (await text(page)) !== before; ++i) await page.keyboard.press('Control+z');
  assert.equal(await text(page), before);
  assert.deepEqual(said, []);
  await context.close();
});

test('a handle moves with the arrow keys', async () => {
  const { page, context } = await opened();
  const handle = page.locator('.handle[data-path="machine.sheaves.tail_block.at"]');
  await handle.focus();
  await page.keyboard.press('ArrowUp');
  await settled(page);
  assert.match(await text(page), /tail_block: \{at: \[200 m, 0 m, 4[0-9.]* m\]/);
  assert.doesNotMatch(await text(page), /tail_block: \{at: \[200 m, 0 m, 40 m\]/);
  await context.close();
});

test('a typo is marked at its place, and the last good picture stays', async () => {
  const { page, context } = await opened();
  const deck = await text(page);
  await write(page, deck.replace('diameter: 350 mm, efficiency: 0.97', 'diamter: 350 mm, efficiency: 0.97'));
  await page.waitForSelector('.error');
  assert.match(await page.locator('.error').first().innerText(), /'diamter' is not a field/);
  assert.ok(await page.locator('#machine.old').count());
  assert.ok(await page.locator('.cm-lintRange-error').count());
  await page.screenshot({ path: join(pictures, 'typo-light-1280.png') });
  await write(page, deck);
  await settled(page);
  assert.equal(await page.locator('.error').count(), 0);
  await context.close();
});

test('while a long calculation runs, no verdict of the deck before stands', async () => {
  const { page, context } = await opened();
  assert.match(await verdict(page), /Passes/);
  await page.locator('#examples').selectOption({ label: 'Telescopic boom, extension rope broken at 17 m, hook' });
  await page.waitForSelector('#verdict[data-kind="pending"]', { timeout: 60000 });
  assert.doesNotMatch(await verdict(page), /Passes/);
  assert.ok(await page.locator('#machine.old').count());
  assert.equal(await page.locator('#checks tr').count(), 0);
  await context.close();
});

test('keys are completed with their words, in lines and in brackets', async () => {
  const { page, context } = await opened();
  const offered = async (deck) => {
    await write(page, deck);
    await page.keyboard.press('Control+Space');
    await page.waitForSelector('.cm-tooltip-autocomplete li', { timeout: 20000 });
    const labels = await page.locator('.cm-tooltip-autocomplete .cm-completionLabel').allInnerTexts();
    await page.keyboard.press('Escape');
    return labels;
  };
  assert.ok((await offered('taut: 1\nmachine:\n  she')).includes('sheaves'));
  assert.ok((await offered('taut: 1\nmachine:\n  sheaves:\n    a: {at: [0 m, 0 m, 1 m], dia')).includes('diameter'));
  assert.ok((await offered('taut: 1\nmachine:\n  points: {}\nanalyses:\n  - load_path: {car')).includes('carriage'));
  assert.ok((await offered('taut: 1\nmethod: mast')).includes('mast_section'));
  await context.close();
});

test('the form of the part under the cursor writes into the deck', async () => {
  const { page, context } = await opened();
  const before = await text(page);
  await page.locator('.cm-line', { hasText: 'mass: 900 kg' }).click();
  const field = page.locator('#form label', { hasText: 'mass' }).locator('input');
  assert.equal(await field.inputValue(), '900 kg');
  await field.fill('950 kg');
  await field.press('Tab');
  await settled(page);
  assert.equal(await text(page), before.replace('mass: 900 kg', 'mass: 950 kg'));
  await context.close();
});

test('the report stands in a frame of its own', async () => {
  const { page, context, said } = await opened();
  await page.click('#choose-report');
  const frame = page.frameLocator('iframe');
  assert.match(await frame.locator('h1').first().innerText(), /Running skyline/);
  assert.equal(await page.locator('iframe').getAttribute('sandbox'), '');
  await page.screenshot({ path: join(pictures, 'report-light-1280.png') });
  // the picture of page 1 takes the share of the row that the report gives it
  const grows = (e) => Number(getComputedStyle(e).flexGrow);
  assert.ok(await frame.locator('figure.key').first().evaluate(grows) > 1);
  const other = said.filter((s) => !/sandboxed/.test(s));
  assert.deepEqual(other, []);
  await context.close();
});

test('a motion plays, with a slider that the keyboard moves', async () => {
  const { page, context } = await opened();
  await example(page, await page.locator('#examples option', { hasText: /recoil|load drop|drop/i }).first().innerText());
  assert.ok(await page.locator('#player').isVisible());
  await page.locator('#time').focus();
  await page.keyboard.press('End');
  const end = await page.locator('#now').innerText();
  await page.keyboard.press('Home');
  assert.notEqual(await page.locator('#now').innerText(), end);
  await page.click('#play');
  await page.waitForTimeout(400);
  assert.notEqual(await page.locator('#time').inputValue(), '0');
  await page.screenshot({ path: join(pictures, 'motion-light-1280.png') });
  await context.close();
});

test('a machine in space is drawn and turns', async () => {
  const { page, context, said } = await opened();
  await page.locator('#view').selectOption('space');
  const canvas = page.locator('#space canvas');
  await page.waitForFunction(() => document.querySelectorAll('#space .names span').length > 0);
  const stage = await page.locator('#stage').boundingBox();
  const seen = [];
  for (const span of await page.locator('#space .names span:visible').all()) {
    const name = await span.boundingBox();
    seen.push(await span.innerText());
    assert.ok(name.x >= stage.x && name.x + name.width <= stage.x + stage.width && name.y >= stage.y, seen.at(-1));
  }
  for (const name of ['tail_block', 'car', 'haulback_drum', 'grid 20 m']) assert.ok(seen.includes(name), seen.join(', '));
  const before = await canvas.screenshot();
  const box = await canvas.boundingBox();
  await page.mouse.move(box.x + 200, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 320, box.y + 240, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(200);
  assert.ok(!before.equals(await canvas.screenshot()));
  assert.deepEqual(said, []);
  await page.screenshot({ path: join(pictures, 'space-light-1280.png') });
  await context.close();
});

test('at 390 px nothing is wider than the screen', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const { page, context } = await opened('', { viewport: { width: 390, height: 844 }, colorScheme });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), colorScheme);
    await page.screenshot({ path: join(pictures, `start-${colorScheme}-390.png`), fullPage: true });
    await context.close();
  }
});

test('200 edits take no more memory than 100', async () => {
  const { page, context } = await opened();
  const deck = await text(page);
  const session = await context.newCDPSession(page);
  const heap = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize;
  };
  const edits = async (n) => {
    for (let i = 0; i < n; ++i) {
      await write(page, deck.replace('mass: 900 kg', `mass: ${900 + (i % 50)} kg`));
      await page.waitForTimeout(30);
    }
    await settled(page);
  };
  await edits(100);
  const half = await heap();
  await edits(100);
  assert.ok((await heap()) < 1.5 * half);
  await context.close();
});
