// Open: a deck with the files that it names, from folders of which a browser tells nothing.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from './engine.mjs';
import { example, opened, settled, text } from './page.mjs';

const file = (name) => join(root, 'examples', name);
const read = (name) => readFileSync(file(name), 'utf8');
const made = (name, body) => ({ name, mimeType: 'text/yaml', buffer: Buffer.from(body) });

async function choose(page, ...files) {
  await page.evaluate(() => { document.getElementById('took').textContent = ''; });
  await page.locator('#file').setInputFiles(files);
}

test('the deck that no other one names is opened, and what it names in other folders is found', async () => {
  const { page, context, said } = await opened();
  const all = ['machines/three_span_skyline.yaml', 'machines/three_span_skyline.csv', 'study/three_span_chance.yaml'];
  assert.match(read(all[2]), /include: \.\.\/machines\/three_span_skyline\.yaml/);
  for (const order of [all, [...all].reverse()]) {
    await choose(page, ...order.map(file));
    await page.waitForFunction(() => /three_span_chance/.test(document.getElementById('deck-name').textContent));
    await settled(page);
    assert.equal(await text(page), read(all[2]));
    assert.equal(await page.locator('.error').count(), 0);
  }
  // a comment names nothing, and a name within another one is another file
  const span = read('machines/clamped_load.yaml');
  const part = made('ab.part.yaml', span);
  const ofParts = 'include: parts/ab.part.yaml\ntitle: Of parts\n';
  await choose(page, made('b.yaml', `# like a.yaml\n${span}`), made('a.yaml', ofParts), part);
  await page.waitForFunction(() => document.getElementById('deck-name').textContent === 'b.yaml');
  await settled(page);
  await choose(page, part, made('a.yaml', ofParts.replace(/parts\S+/, '"$&"')));
  await page.waitForFunction(() => document.title === 'Of parts - taut');
  // the same file can be chosen again
  assert.equal(await page.locator('#file').inputValue(), '');
  assert.deepEqual(said, []);
  await context.close();
});

test('a mistake in an included deck is told with its file, and leads to no line of another one', async () => {
  const { page, context } = await opened();
  const main = ['taut: 1', 'title: With a part', 'include: ropes/list.part.yaml', 'machine:',
    '  points: {a: [0 m, 0 m, 12 m]}', '  colour: red', ''].join('\n');
  await choose(page, made('main.yaml', main),
    made('list.part.yaml', '# one\n# two\nmachine:\n  ropes:\n    r: {mass: 1 kg/m, breaking_forc: 200 kN}\n'));
  await page.waitForSelector('.error');
  const there = page.locator('.error', { hasText: 'breaking_forc' });
  assert.match(await there.innerText(), /^ropes\/list\.part\.yaml:5:/);
  const cursor = () => page.evaluate(() => {
    const content = document.querySelector('.cm-content');
    const { doc, selection } = (content.cmTile?.view ?? content.cmView.view).state;
    return doc.lineAt(selection.main.head).number;
  });
  await page.locator('.cm-line').nth(1).click();
  await there.click();
  assert.equal(await cursor(), 2);
  assert.equal(await there.evaluate((e) => e.tagName), 'P');
  await page.locator('button.error', { hasText: 'colour' }).click();
  assert.equal(await cursor(), 6);
  await context.close();
});

test('beside a deck with a mistake nothing of the deck before is shown', async () => {
  const { page, context } = await opened();
  await page.click('#choose-plots');
  assert.ok(await page.locator('#plots figure').count() > 0);
  await choose(page, made('bad.yaml', 'taut: 1\ntitle: Bad\nmachine: {colour: red}\n'));
  await page.waitForSelector('.error', { state: 'attached' });
  assert.equal(await page.title(), 'bad.yaml - taut');
  assert.equal(await page.locator('#plots figure').count(), 0);
  assert.equal(await page.locator('.handle').count(), 0);
  await page.click('#choose-report');
  assert.match(await page.frameLocator('iframe').locator('body').innerText(), /colour/);
  await context.close();
});

test('the machine in space is seen whole when another one is opened, and as before when it is changed', async () => {
  const { page, context } = await opened();
  const spread = () => page.locator('#space .names .name').evaluateAll((all) => {
    const x = all.map((e) => e.getBoundingClientRect().left), y = all.map((e) => e.getBoundingClientRect().bottom);
    return Math.max(Math.max(...x) - Math.min(...x), Math.max(...y) - Math.min(...y));
  });
  await page.locator('#view').selectOption('space');
  await page.waitForFunction(() => document.querySelectorAll('#space .names .name').length > 3);
  const stage = await page.locator('#stage').boundingBox();
  await example(page, 'Six-part tackle, hoisting against lowering');
  await page.waitForTimeout(500);
  assert.ok(await spread() > stage.height / 3, `${await spread()}`);
  await example(page, 'Ropeway with a counterweight');
  await page.waitForTimeout(500);
  const whole = await spread();
  assert.ok(whole > stage.height / 3 && whole < stage.width, `${whole}`);
  await context.close();
});
