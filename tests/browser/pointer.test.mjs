// The map under the pointer, and the exact images of the mesh, in a real browser.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** The unit disk onto itself, with x₁ = a: f(z) = (z − a)/(1 − a z) up to a rotation. */
const A = 0.5;

async function openDisks(app, kernel) {
  const { source, target } = await app.session();
  const disk = (side) => ({ ...side, outline: { preset: 'disk' }, settings: { ...side.settings, kernel } });
  await app.openSession({ source: disk(source), target: disk(target), interior: [[A, 0], [0, 0]], anchor: [0, 0] });
  return app.atRest('the disks are mapped');
}

/** |f| and |f′| at a point. */
function moebius([x, y]) {
  const below = Math.hypot(1 - A * x, A * y);
  return { size: Math.hypot(x - A, y) / below, scale: (1 - A * A) / below ** 2 };
}

withOneBackend('the pointer', (bench) => {
  test(
    'image, scale and turning of the point under the pointer are right to ten digits, and gone with the pointer',
    bench.withApp(async (app) => {
      const { handles } = await openDisks(app, 'integral');
      await app.pointAt([handles.x1[0] - 70, handles.x1[1] + 90]);
      const { pointed } = await app.until('the integral is prepared', (stats) => stats.pointed?.errors);
      const { size, scale } = moebius(pointed.point);
      assert.equal(pointed.side, 'source');
      assert.ok(Math.abs(Math.hypot(...pointed.image) - size) < 1e-10, JSON.stringify(pointed));
      assert.ok(Math.abs(Math.hypot(...pointed.derivative) - scale) < 1e-9, JSON.stringify(pointed));
      assert.ok(pointed.errors.image < 1e-9);
      await app.shot(`${bench.backend}-pointer`);
      await app.pointAt([handles.x1[0], 10]);
      await app.until('nothing is under the pointer', (stats) => stats.pointed === null);
    }),
  );

  test(
    'with finite elements it is interpolated in the mesh',
    bench.withApp(async (app) => {
      const { handles } = await openDisks(app, 'adjoint');
      await app.pointAt([handles.x1[0] - 70, handles.x1[1] + 90]);
      const { pointed } = await app.until('a triangle is under the pointer', (stats) => stats.pointed);
      assert.equal(pointed.errors, null);
      assert.ok(Math.abs(Math.hypot(...pointed.image) - moebius(pointed.point).size) < 0.03, JSON.stringify(pointed));
    }),
  );

  test(
    'a tap shows the map at that point on a phone',
    bench.withApp(
      async (app) => {
        const { handles } = await app.atRest('the first map is there');
        await app.tap([handles.x1[0], handles.x1[1] + 45]);
        const { pointed } = await app.until('the integral is prepared', (stats) => stats.pointed?.errors);
        assert.equal(pointed.side, 'source');
        await app.shot(`${bench.backend}-pointer-phone`);
      },
      { device: 'phone' },
    ),
  );

  test(
    'exact images are chosen, complete at rest, and kept in the session; finite elements have none',
    bench.withApp(async (app) => {
      const { undo, image_of_mapped_point: harmonic } = await openDisks(app, 'integral');
      await app.unfoldAdvanced();
      await app.walkTo(/^Exact, choice, not selected/);
      await app.press('Space');
      const isExact = (stats, count) => stats.ready && stats.undo === count && stats.extension_progress === 1;
      const exact = await app.atRest('the images are exact', isExact, undo + 1);
      assert.equal((await app.session()).extension, 'exact');
      const { image_of_mapped_point: [u, v], expected } = exact;
      assert.notDeepEqual([u, v], harmonic);
      // interpolated in a triangle of exact images
      assert.ok(Math.hypot(u - expected[0], v - expected[1]) < 1e-3, `${[u, v]} for ${expected}`);
      await app.shot(`${bench.backend}-exact`);
      await openDisks(app, 'adjoint');
      await app.walkTo(/^Exact, choice, not selected, not available/);
    }),
  );
});
