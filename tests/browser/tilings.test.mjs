// The hyperbolic tiling: chosen and changed by keyboard, carried along by x₁, kept through a reload, in an SVG file.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { SHARP } from './app.mjs';
import { withEachBackend } from './backends.mjs';

/** Types into the field that has the focus. */
async function typed(app, text) {
  await app.press('Control+a');
  await app.page.keyboard.type(text);
  await app.press('Enter');
}

/** Chooses a position of a switch by keyboard. */
async function choose(app, name) {
  await app.walkTo(name);
  await app.press('Space');
  return app.atRest('the pattern is chosen');
}

/** The color of the source above x₁, in the middle tile. */
async function aboveX1(app, { handles }) {
  const [x, y] = handles.x1;
  return (await app.pixelsOf(await app.screenshot(), [[Math.round(x), Math.round(y) - 24]]))[0];
}

/** Maps the disk to the disk, with x₁ and x₂ in the middle. */
async function openDisks(app) {
  const { source, target } = await app.session();
  const disk = (side) => ({ ...side, outline: { preset: 'disk' } });
  await app.openSession({ source: disk(source), target: disk(target), interior: [[0, 0], [0, 0]], anchor: [0, 0] });
  return app.atRest('the disks are mapped');
}

withEachBackend('the hyperbolic tiling', (bench) => {
  test(
    'is chosen, keeps its middle tile at x₁ while that is dragged, and comes back after a reload',
    bench.withApp(async (app) => {
      await openDisks(app);
      const tiled = await choose(app, /^Tiles, choice/);
      const { tiling, texture } = await app.session();
      assert.deepEqual(tiling, { numbers: [7, 3], style: 'tiles', shown: true });
      assert.equal(texture, 'conformal', 'for older programs');
      const [red, , blue] = await aboveX1(app, tiled);
      assert.ok(red > blue + 30, `the middle tile is orange, not ${red}, ${blue}`);
      await app.shot(`${bench.backend}-tiling`);

      const [x, y] = tiled.handles.x1;
      await app.drag([x, y], [x + 30, y - 60]);
      const dragged = await app.atRest('x₁ has moved', (stats, last) => stats.ready && Math.abs(stats.handles.x1[1] - last) > 30, y);
      const [redAfter, , blueAfter] = await aboveX1(app, dragged);
      assert.ok(redAfter > blueAfter + 30, `the tile has come along: ${redAfter}, ${blueAfter}`);

      await app.reload();
      await app.atRest('it is there again');
      assert.deepEqual((await app.session()).tiling, tiling);
    }, SHARP),
  );

  test(
    'explains numbers that are no hyperbolic tiling, and takes the next that are',
    bench.withApp(async (app) => {
      await app.atRest('the map is there');
      const { undo } = await choose(app, /^Tiles, choice/);
      await app.walkTo(/^Sides, slider/);
      await typed(app, '4');
      await app.walkTo(/^At a corner\. .*lives on the sphere: it is the cube/);
      await typed(app, '5');
      await app.until('one step', (stats, last) => stats.ready && stats.undo === last + 1, undo);
      assert.deepEqual((await app.session()).tiling.numbers, [4, 5]);
      await choose(app, /^Mirrors, choice/);
      await app.shot(`${bench.backend}-mirrors`);
      await app.press('Control+z');
      await app.press('Control+z');
      await app.until('heptagons again', (stats, last) => stats.ready && stats.undo === last, undo);
      assert.deepEqual((await app.session()).tiling.numbers, [7, 3]);
    }),
  );
});
