// Four marks of an outline: its rectangle with one click, and its orthogonal grid, on the screen and as files.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Shows the L with four marks, and its modulus. */
async function marked(app) {
  const { source } = await app.session();
  await app.openSession({ source: { ...source, outline: { preset: 'l-shape' } } });
  await app.atRest('the L is shown');
  await app.unfoldAdvanced();
  await app.walkTo(/^Invariants · source, check box, not selected/i);
  await app.press('Space');
  await app.walkTo(/^Four marks, check box, not selected/);
  await app.press('Space');
  return app.until('the modulus is there', (stats) => stats.ready && stats.invariants[0]?.Ok?.modulus);
}

/** The numbers of cells that a grid begins with: about 200, nearly square. */
function squareCells(modulus) {
  return [200 / modulus, 200 * modulus].map((product) => Math.round(Math.sqrt(product)));
}

withOneBackend('quadrilaterals', (bench) => {
  test(
    'the rectangle of the marks is one click and one step to undo away, and the fourth corner is met',
    bench.withApp(async (app) => {
      const { undo } = await marked(app);
      await app.walkTo(/^Map onto its rectangle, button/);
      await app.press('Space');
      const isMet = (stats) =>
        stats.ready && stats.pin_misses?.length === 3 && Math.max(...stats.pin_misses) < 1e-6;
      const pinned = await app.atRest('three pins are met', isMet);
      assert.equal(pinned.undo, undo + 1);
      const { points } = (await app.session()).target.outline.points;
      assert.equal(points.length, 4);
      const ratio = (points[3][1] - points[0][1]) / (points[1][0] - points[0][0]);
      const { value } = pinned.invariants[0].Ok.modulus;
      assert.ok(Math.abs(ratio / value - 1) < 1e-9, `${ratio} for the modulus ${value}`);
      await app.walkTo(/^Orthogonal grid, check box, not selected/);
      await app.press('Space');
      const [n, m] = squareCells(value);
      const hasLines = (stats, lines) => stats.ready && stats.grid_lines.every((count) => count === lines);
      await app.atRest('the grid and the lattice are there', hasLines, n + m - 2);
      await app.shot(`${bench.backend}-quadrilateral`);
      const cells = new RegExp(`Orthogonal grid · [Ss]ource: ${n} × ${m} cells\\. Nodes right to `);
      await app.saying('state', cells);
      await app.press('Control+z');
      const undone = await app.atRest('the heart is back', (stats) => stats.ready && stats.pin_misses === null);
      assert.deepEqual(undone.grid_lines, [n + m - 2, 0], 'the grid stays with the marks');
    }),
  );

  test(
    'a grid is saved as a table, and other numbers of cells give another one',
    bench.withApp(async (app) => {
      const { invariants } = await marked(app);
      const [n, m] = squareCells(invariants[0].Ok.modulus.value);
      await app.walkTo(/^Orthogonal grid, check box, not selected/);
      await app.press('Space');
      const { grids } = await app.until('the grid is there', (stats) => stats.grids[0]?.Ok);
      const { image_error: error, angle_deviation: angle } = grids[0].Ok;
      assert.ok(error < 1e-5 && angle < 1e-4, `nodes to ${error}, angles to ${angle}°`);
      await app.walkTo(/^Save the grid as CSV, button/);
      const { name, bytes } = await app.downloadBy('Space');
      assert.equal(name, 'riemap_grid.csv');
      const rows = bytes.toString().trim().split('\n');
      assert.deepEqual([rows[0], rows.length], ['i,j,x,y', 1 + (n + 1) * (m + 1)]);
      await app.walkTo(/^cells from mark 1 to 2/);
      await app.press('Control+a');
      await app.page.keyboard.type('150');
      await app.press('Enter');
      await app.until('every second line is drawn', (stats, lines) => stats.grid_lines[0] === lines, 74 + m - 1);
    }),
  );

  test(
    'a mark is dragged along the outline in one step, and a reload and the link keep it',
    bench.withApp(async (app) => {
      await marked(app);
      const before = await app.atRest('the marks are there', (stats) => stats.ready && stats.handles.marks[0].length === 4);
      const { marks } = (await app.session()).source;
      const [x, y] = before.handles.marks[0][0];
      await app.drag([x, y], [x + 30, y - 10]);
      const after = await app.atRest(
        'the mark has moved',
        (stats, undo) => stats.ready && stats.undo === undo + 1 && stats.invariants[0]?.Ok?.modulus,
        before.undo,
      );
      const moved = (await app.session()).source.marks;
      assert.ok(moved[0] !== marks[0] && moved.slice(1).every((mark, k) => mark === marks[k + 1]), `${marks} to ${moved}`);
      assert.notEqual(after.invariants[0].Ok.modulus.value, before.invariants[0].Ok.modulus.value);
      await app.shot(`${bench.backend}-marks`);
      await app.saying('state', /Marks of the source at \d/);
      await app.reload();
      await app.atRest('the map is there again');
      assert.deepEqual((await app.session()).source.marks, moved);
      await app.press('Control+z');
      await app.until('the mark is back', (stats, undo) => stats.undo === undo, before.undo);
      assert.deepEqual((await app.session()).source.marks, marks);
    }),
  );
});

withOneBackend('chains', (bench) => {
  test(
    'the target becomes the source, and one undo brings the former one back',
    bench.withApp(async (app) => {
      const before = await app.atRest('the map is there');
      const { source, target } = await app.session();
      await app.walkTo(/^Shapes, button/);
      await app.press('Space');
      await app.walkTo(/^Continue from the target, button/);
      await app.shot(`${bench.backend}-continue`);
      await app.press('Space');
      const isNext = (stats, undo) => stats.ready && stats.undo === undo + 1;
      await app.atRest('the target is the source, too', isNext, before.undo);
      const next = await app.session();
      assert.deepEqual([next.source, next.target], [target, target]);
      await app.press('Control+z');
      await app.atRest('the former source is back', (stats, undo) => stats.ready && stats.undo === undo, before.undo);
      assert.deepEqual((await app.session()).source, source);
    }),
  );
});
