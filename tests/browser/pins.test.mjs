// Pins: chosen in the panel, dragged, added and removed, with undo, through a link and a reload.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

const isMet = (stats) => stats.ready && stats.pin_misses !== null && Math.max(...stats.pin_misses) < 1e-8;

/** Chooses pins; the map stays. */
async function pinned(app) {
  const before = await app.atRest('the map is there');
  await app.walkTo(/^Pins, /);
  await app.press('Space');
  const after = await app.atRest('three pins are met', isMet);
  assert.deepEqual(after.handles.pins.map((side) => side.length), [3, 3]);
  const off = Math.abs(after.boundary_checksum - before.boundary_checksum);
  assert.ok(off < 1e-6, `the map stays, up to ${off}`);
  return after;
}

withOneBackend('pins', (bench) => {
  test(
    'a dragged pin is met, in the picture, in the link and after a reload',
    bench.withApp(async (app) => {
      const before = await pinned(app);
      const [x, y] = before.handles.pins[1][1];
      await app.drag([x, y], [x + 12, y + 12]);
      const after = await app.atRest(
        'the pin has moved, and the map with it',
        (stats, last) => stats.ready && Math.max(...stats.pin_misses) < 1e-8 && stats.boundary_checksum !== last,
        before.boundary_checksum,
      );
      await app.shot('pins');
      const moved = Math.hypot(after.handles.pins[1][1][0] - x, after.handles.pins[1][1][1] - y);
      assert.ok(moved > 4, `moved by ${moved}`);
      const { pins } = await app.session();
      assert.equal(pins.length, 3);
      await app.reload();
      const again = await app.atRest('the pins are there again', isMet);
      assert.deepEqual((await app.session()).pins, pins);
      const off = Math.abs(again.boundary_checksum - after.boundary_checksum);
      assert.ok(off < 1e-6, `the same map, up to ${off}`);
    }),
  );

  test(
    'a pin is added with its image, removed by a key, and both can be undone',
    bench.withApp(async (app) => {
      const before = await pinned(app);
      await app.walkTo(/^Add a pin, button/);
      await app.press('Space');
      const four = await app.atRest('four pins', (stats) => stats.ready && stats.pin_misses?.length === 4);
      assert.ok(Math.abs(four.boundary_checksum - before.boundary_checksum) < 1e-6, 'the map stays');
      assert.equal(four.undo, before.undo + 1);
      await app.walkTo(/^Pin 4 of the source/);
      await app.press('Delete');
      await app.atRest('three pins', (stats) => stats.ready && stats.pin_misses?.length === 3);
      await app.press('Control+z');
      await app.atRest('four pins again', (stats) => stats.ready && stats.pin_misses?.length === 4);
      await app.press('Control+z');
      await app.press('Control+z');
      const points = await app.atRest('points again', (stats) => stats.ready && stats.pin_misses === null);
      assert.deepEqual(points.handles.pins, [[], []]);
    }),
  );
});
