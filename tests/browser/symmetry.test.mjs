// Symmetries of outlines: shown, said and listed; dots are caught by axes and corners, and freed by Alt.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

withOneBackend('symmetry', (bench) => {
  test(
    'a dragged point is caught by an axis, free beside it and with Alt, and the symmetries are in the link',
    bench.withApp(async (app) => {
      await app.atRest('the map is there');
      await app.unfoldAdvanced();
      await app.walkTo(/^Show and snap, check box, not selected/);
      await app.press('Space');
      const shown = await app.atRest('the symmetries are there', (stats) => stats.ready && stats.symmetries.every((side) => side));
      assert.deepEqual(shown.symmetries.map(({ turns, axes }) => [turns, axes.map(Math.round)]), [[1, [90]], [1, [90]]]);
      await app.saying('state', /Symmetry of source: Axis at 90°, off by 0.00 %/);
      const { x1, y1 } = shown.handles;
      // the gingerbread man's boundary point is at the top of his axis
      const axis = y1[0];
      await app.hold(x1, [axis + 6, x1[1] + 12]);
      const caught = await app.until('the axis has caught the point', (stats) => stats.handles.caught?.includes('on the axis at 90°'));
      assert.ok(Math.abs(caught.handles.x1[0] - axis) < 0.5, `${caught.handles.x1} is on the axis at ${axis}`);
      await app.shot(`${bench.backend}-symmetry`);
      await app.pointAt([axis + 14, x1[1] + 12]);
      const free = await app.until('the point is free', (stats) => stats.handles.caught === null);
      assert.ok(free.handles.x1[0] - axis > 10, `${free.handles.x1} is beside the axis at ${axis}`);
      await app.page.keyboard.down('Alt');
      await app.pointAt([axis + 5, x1[1] + 12]);
      const freed = await app.until('with Alt it stays free', (stats, at) => stats.handles.x1[0] < at + 8 && stats.handles.caught === null, axis);
      assert.ok(freed.handles.x1[0] - axis > 3, `${freed.handles.x1} is beside the axis at ${axis}`);
      await app.page.keyboard.up('Alt');
      await app.pointAt([axis + 5, x1[1] + 14]);
      await app.letGo();
      const after = await app.atRest('it is caught again', (stats) => stats.ready && stats.handles.caught !== null);
      assert.equal(after.undo, shown.undo + 1, 'the drag is one step');
      await app.saying('state', /x₁ is on the axis at 90°\./);
      await app.reload();
      await app.atRest('the symmetries are there again', (stats) => stats.ready && stats.symmetries.every((side) => side));
    }),
  );

  test(
    'a corner catches a boundary point where no symmetries are shown',
    bench.withApp(async (app) => {
      const { source } = await app.session();
      await app.openSession({ source: { ...source, outline: { preset: 'square' } } });
      const { handles } = await app.atRest('the square is shown');
      const [x, y] = handles.y1;
      const half = Math.abs(handles.x1[1] - y);
      await app.hold([x, y], [x + half - 5, y + 3]);
      const caught = await app.until('the corner has caught it', (stats) => stats.handles.caught?.includes('in a corner'));
      assert.ok(Math.abs(caught.handles.y1[0] - x - half) < 1, `${caught.handles.y1} is ${half} beside ${x}`);
      await app.letGo();
      await app.atRest('at rest', (stats) => stats.ready);
      const { anchor, source: side } = await app.session();
      assert.ok(Math.abs((side.anchor ?? anchor[0]) - 0.875) < 1e-12, 'the corner itself');
    }),
  );
});
