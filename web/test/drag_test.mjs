// Loads and the carriage of the picture: a drag writes the number into the deck, undo takes it back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { example, link, opened, pictures, settled, text } from './page.mjs';
import { join } from 'node:path';

/** Drags a handle by pixels, as a hand does. */
async function drag(page, path, right, down) {
  const box = await page.locator(`.handle[data-path="${path}"]`).boundingBox();
  const at = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(...at);
  await page.mouse.down();
  for (let i = 1; i <= 5; ++i) await page.mouse.move(at[0] + (right * i) / 5, at[1] + (down * i) / 5);
  await page.mouse.up();
  await settled(page);
}

async function undone(page, before) {
  await page.locator('.cm-content').focus();
  for (let i = 0; i < 20 && (await text(page)) !== before; ++i) await page.keyboard.press('Control+z');
  assert.equal(await text(page), before);
}

test('the arrow of a mass is dragged: heavier below, and the answer follows', async () => {
  const { page, context, said } = await opened();
  const before = await text(page);
  const tension = () => page.locator('#values tr', { hasText: 'T_max' }).first().innerText();
  await page.click('#choose-values');
  const light = await tension();
  await drag(page, 'machine.loads[0].mass', 0, 14);
  const moved = await text(page);
  const mass = /\{at: car, mass: (\S+) kg\}/.exec(moved)[1];
  assert.ok(Number(mass) > 1000 && Number(mass) < 1500, mass);
  assert.equal(moved.replace(`mass: ${mass} kg`, 'mass: 900 kg'), before);
  assert.notEqual(await tension(), light);
  await page.screenshot({ path: join(pictures, 'load-light-1280.png') });
  await undone(page, before);
  assert.deepEqual(said, []);
  await context.close();
});

test('no mass becomes negative, and from above none is drawn', async () => {
  const { page, context } = await opened();
  await example(page, 'Single span with a clamped load');
  await drag(page, 'machine.loads[0].mass', 0, -80);
  assert.match(await text(page), /\{at: car, mass: 0 t\}/);
  await page.locator('#view').selectOption('plan');
  await page.waitForFunction(() => !document.querySelector('.handle[data-path="machine.loads[0].mass"]'));
  await context.close();
});

test('the arrow of a force is dragged in its plane; the third number and the comment stay', async () => {
  const { page, context, said } = await opened();
  await example(page, 'Tower yarder, elastic mast with four guys');
  const before = await text(page);
  await drag(page, 'machine.loads[0].force', -20, 10);
  const moved = await text(page);
  const [x, y, z] = /force: \[(.*?)\]\} {6}# skyline, downhill/.exec(moved)[1].split(', ');
  assert.ok(parseFloat(x) < 50 && x.endsWith(' kN'), x);
  assert.equal(y, '5 kN');
  assert.ok(parseFloat(z) < -23 && z.endsWith(' kN'), z);
  await undone(page, before);
  assert.deepEqual(said, []);
  await context.close();
});

test('the carriage is dragged along x where the deck gives its place', async () => {
  const { page, context, said } = await opened();
  await example(page, 'Single span with a clamped load');
  const before = await text(page);
  const path = 'analyses[0].equilibrium.x';
  const at = async () => (await page.locator(`.handle[data-path="${path}"]`).boundingBox()).x;
  const old = await at();
  await drag(page, path, 60, 0);
  const moved = await text(page);
  const x = /carriage: car, x: (\S+) m\}/.exec(moved)[1];
  assert.ok(Number(x) > 140 && Number(x) < 200, x);
  assert.equal(moved.replace(`x: ${x} m}`, 'x: 125 m}'), before);
  // the new picture has the carriage where the hand has left it
  assert.ok(Math.abs((await at()) - old - 60) < 3);
  await undone(page, before);
  assert.deepEqual(said, []);
  await context.close();
});

test('a carriage at a height, along a slanted line, is dragged both ways', async () => {
  const { page, context } = await opened();
  await example(page, 'Running skyline with a two-section carriage');
  await drag(page, 'analyses[0].equilibrium.x', 0, 10);
  assert.match(await text(page), /carriage: first, x: 100 m, z: [789](\.\d+)? m\}/);
  await example(page, 'Half-suspended bunch dragged uphill');
  const before = await text(page);
  await drag(page, 'analyses[0].equilibrium.x', 30, 0);
  const x = /carriage: car, x: (\S+) m, along: \[190.5, 110\]\}/.exec(await text(page))[1];
  assert.ok(Number(x) > 125, x);
  await undone(page, before);
  await context.close();
});

test('loads and carriage move with the arrow keys and say what they are', async () => {
  const { page, context } = await opened();
  const load = page.getByRole('button', { name: 'load on car, 900 kg; arrow keys change it' });
  await load.focus();
  await page.keyboard.press('ArrowDown');
  await settled(page);
  const one = Number(/\{at: car, mass: (\S+) kg\}/.exec(await text(page))[1]);
  assert.ok(one > 900);
  await page.keyboard.press('Shift+ArrowDown');
  await settled(page);
  assert.equal(Number(/\{at: car, mass: (\S+) kg\}/.exec(await text(page))[1]), one + 10 * (one - 900));
  assert.equal(await page.getByRole('button', { name: /^first guess of the place of car/ }).count(), 1);
  await context.close();
});

test('a load by an expression has no handle', async () => {
  const { page, context } = await opened();
  const deck = await text(page);
  await context.close();
  const parameters = deck.replace('title:', 'parameters: {load: 900 kg}\ntitle:').replace('mass: 900 kg', 'mass: = load');
  const other = await opened(link({ name: 'deck.yaml', text: parameters, files: {} }));
  assert.equal(await other.page.locator('.handle[data-kind="load"]').count(), 0);
  assert.ok(await other.page.locator('.handle').count());
  await other.context.close();
});
