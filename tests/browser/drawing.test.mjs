// Outlines drawn by clicks, reshaped while the map follows, self-crossing, undone, pasted.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** A square whose handles are at known points of the outline. */
const SQUARE = '0,0\n2,0\n2,2\n0,2\n';

withOneBackend('outlines by hand', (bench) => {
  /** Starts reshaping a square on the left; returns the positions of its handles, counter-clockwise from lower left. */
  const editSquare = async (app) => {
    await app.loadOutline('source', 'square.csv', SQUARE);
    const { handles } = await app.atRest('the square is there', (stats) => stats.ready && stats.undo === 1);
    await app.pointAt([handles.x1[0], handles.x1[1] + 60]);
    await app.press('e');
    const { editing } = await app.atRest('it can be reshaped', (stats) => stats.editing);
    assert.equal(editing.handles.length, 4);
    return editing.handles;
  };

  test(
    'the map follows a handle while it is dragged, and the drag is one step',
    bench.withApp(async (app) => {
      const handles = await editSquare(app);
      const start = await app.session();
      const { generation } = await app.stats();
      const to = [handles[2][0] - 60, handles[2][1] + 40];
      await app.hold(handles[2], to);
      const held = await app.until(
        'a coarse map follows',
        (stats, before) => stats.generation > before && stats.source.m <= 500 && !stats.ready,
        generation,
      );
      assert.equal((await app.session()).source.outline.points.points.length, 4);
      assert.equal(held.undo, 1, 'nothing has come to rest');
      await app.letGo();
      const rested = await app.until('the full map comes', (stats) => stats.ready && stats.undo === 2);
      assert.ok(rested.source.m > 500, `${rested.source.m} samples`);
      const [x, y] = rested.editing.handles[2];
      assert.ok(Math.hypot(x - to[0], y - to[1]) < 2, `${x}, ${y}`);
      await app.press('Control+z');
      await app.until('the drag is taken back', (stats) => stats.ready && stats.undo === 1);
      assert.deepEqual(await app.session(), start);
    }),
  );

  test(
    'while the outline crosses itself the last good map stays, and the place is marked',
    bench.withApp(async (app) => {
      const handles = await editSquare(app);
      const beyond = [handles[0][0] - 40, 0.5 * (handles[0][1] + handles[3][1])];
      await app.hold(handles[2], beyond, 6);
      const { editing } = await app.until('the crossing is seen', (stats) => stats.editing?.crossing);
      assert.match(editing.message, /crosses itself/);
      assert.ok(Math.abs(editing.crossing[0] - handles[0][0]) < 3, `the left edge is crossed: ${editing.crossing}`);
      await app.shot(`${bench.backend}-crossing`);
      await app.letGo();
      const after = await app.until('the good one is prepared', (stats) => stats.ready && stats.editing && !stats.editing.crossing);
      assert.match(after.editing.message, /last good one was kept/);
      assert.deepEqual(after.errors, [after.editing.message]);
      assert.equal(after.flipped, 0);
    }),
  );

  test(
    'an outline is drawn by clicks, and closed by a click on its first point',
    bench.withApp(async (app) => {
      const { handles } = await app.stats();
      const [x, y] = handles.x1;
      await app.pointAt([x, y + 60]);
      await app.press('l');
      await app.until('it can be drawn', (stats) => stats.editing?.draws);
      const corners = [[x - 120, y + 100], [x + 120, y + 100], [x + 90, y - 60], [x - 70, y - 110]];
      for (const [k, corner] of corners.entries()) {
        await app.click(corner);
        await app.until('the point is set', (stats, count) => stats.editing?.handles.length === count, k + 1);
      }
      await app.click(corners[0]);
      await app.until('the map is there', (stats) => stats.ready && stats.undo === 1 && !stats.editing);
      const { points } = (await app.session()).source.outline.points;
      assert.equal(points.length, 4);
    }),
  );

  test(
    'path data that is pasted becomes the source, and what is no outline is told',
    bench.withApp(async (app) => {
      await app.pasteText('M 0 0 L 4 0 L 4 1 L 1 3 Z');
      await app.until('the map is there', (stats) => stats.ready && stats.undo === 1);
      const { points } = (await app.session()).source.outline.points;
      assert.deepEqual(points.length, 4);
      await app.pasteText('0,0 2,0 1,2 0');
      const { editing } = await app.until('the text is refused', (stats) => stats.editing?.message);
      assert.match(editing.message, /7 numbers/);
      await app.press('Escape');
      await app.until('the window is closed', (stats) => !stats.editing);
    }),
  );
});
