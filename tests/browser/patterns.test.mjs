// The patterns in a real browser, with either backend: cells are seen whatever the map and the zoom do.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { SHARP } from './app.mjs';
import { withEachBackend } from './backends.mjs';

/** How often light and dark squares alternate within 150 points left and right of `place`, a bit below it. */
async function squaresAround(app, [x, y]) {
  const png = await app.screenshot();
  const row = Array.from({ length: 151 }, (_, k) => [Math.round(x) - 150 + 2 * k, Math.round(y) + 37]);
  const light = (await app.pixelsOf(png, row)).map(([, green]) => green > 170);
  return light.filter((is, k) => k > 0 && is !== light[k - 1]).length;
}

const openDisks = async (app, x1) => {
  const { source, target } = await app.session();
  const disk = (side) => ({ ...side, outline: { preset: 'disk' } });
  await app.openSession({ source: disk(source), target: disk(target), interior: [[x1, 0], [0, 0]], anchor: [0, 0] });
  return app.atRest('the disks are mapped');
};

withEachBackend('the pattern', (bench) => {
  test(
    'has squares of the usual size where x₁ lies next to the edge, and at a zoom of ten',
    bench.withApp(async (app) => {
      const usual = await squaresAround(app, (await openDisks(app, 0)).handles.x2);
      assert.ok(usual >= 6, `${usual} changes in the identity`);
      const { handles } = await openDisks(app, 0.985);
      const magnified = await squaresAround(app, handles.x2);
      assert.ok(magnified >= 6 && magnified <= 3 * usual, `${magnified} changes where |f′| is 1/70 to 130, ${usual} before`);
      await app.pointAt([handles.x1[0] - 120, handles.x1[1] + 20]);
      for (let k = 0; k < 10; k++) await app.page.mouse.wheel(0, -120);
      const zoomed = await app.atRest('the source is larger', (stats, x) => stats.ready && Math.abs(stats.handles.x1[0] - x) > 100, handles.x1[0]);
      assert.ok(zoomed.ready);
      const source = await squaresAround(app, [handles.x1[0] - 120, handles.x1[1] - 20]);
      assert.ok(source >= 6 && source <= 3 * usual, `${source} changes in the magnified source, ${usual} before`);
      await app.shot(`${bench.backend}-octaves`);
    }, SHARP),
  );
});
