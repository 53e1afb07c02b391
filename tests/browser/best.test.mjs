// The best map: found from the panel with one undo step, its landscape, and a region painted with the brush.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

const isDone = (stats) => stats.ready && stats.best.result !== null && !stats.best.moving;

withOneBackend('the best map', (bench) => {
  test(
    'it is found, the points move there, and one undo brings them back',
    bench.withApp(async (app) => {
      const before = await app.atRest('the map is there');
      await app.walkTo(/^Find it, button/);
      await app.press('Space');
      const after = await app.atRest('the best map is shown', isDone);
      const [first, best] = after.best.result;
      assert.ok(best < 0.9 * first, `${first} → ${best}`);
      assert.equal(after.undo, before.undo + 1);
      const moved = Math.abs(after.boundary_checksum - before.boundary_checksum);
      assert.ok(moved > 1e-3, `the map has changed by ${moved}`);
      await app.shot('best-map');
      await app.press('Control+z');
      const back = await app.atRest('the points are back', (stats, undo) => stats.ready && stats.undo === undo, before.undo);
      assert.ok(Math.abs(back.boundary_checksum - before.boundary_checksum) < 1e-9, 'the same map');
    }),
  );

  test(
    'over the landscape a click moves x₁',
    bench.withApp(async (app) => {
      const before = await app.atRest('the map is there');
      await app.walkTo(/^Landscape over x₁, check box/);
      await app.press('Space');
      const shown = await app.atRest('the landscape is there', (stats) => stats.ready && stats.best.lowest !== null);
      await app.shot('landscape');
      const [x, y] = before.handles.x1;
      await app.click([x, y + 60]);
      const after = await app.atRest(
        'x₁ has moved',
        (stats, [left, top]) => stats.ready && Math.hypot(stats.handles.x1[0] - left, stats.handles.x1[1] - top) < 3,
        [x, y + 60],
      );
      assert.equal(after.best.lowest, shown.best.lowest, 'the landscape stays');
      assert.equal(after.undo, before.undo + 1);
    }),
  );

  test(
    'a painted region is kept through a reload, and its areas become even',
    bench.withApp(async (app) => {
      const before = await app.atRest('the map is there');
      await app.walkTo(/^Region, choice/);
      await app.press('Space');
      await app.walkTo(/^Paint with the brush, check box/);
      await app.press('Space');
      const [x, y] = before.handles.x1;
      await app.drag([x - 40, y + 60], [x + 40, y + 60]);
      const painted = await app.atRest('a stroke is painted', (stats) => stats.ready && stats.best.region > 1);
      assert.equal(painted.undo, before.undo + 1, 'a stroke is one step');
      await app.shot('region');
      await app.reload();
      const again = await app.atRest('the region is there again', (stats) => stats.ready && stats.best.region > 1);
      assert.equal(again.best.region, painted.best.region);
      await app.walkTo(/^Region, choice/);
      await app.press('Space');
      await app.walkTo(/^Find it, button/);
      await app.press('Space');
      const after = await app.atRest('the best map is shown', isDone);
      assert.ok(after.best.result[1] < after.best.result[0], `${after.best.result}`);
    }),
  );
});
