// The boundary integral in a browser: finite elements first, then the factored equation.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Sides whose equations are factored within a second, also without optimized wasm. */
const SMALL = { outline: { preset: 'l-shape' }, interior: null, anchor: 0 };

const kernelsOf = ({ kernels }) => kernels.map((side) => side?.kernel);

/** The present session with these outlines and this kernel. */
async function open(app, outline, kernel) {
  const { source, target } = await app.session();
  const changed = (side, own) => ({ ...side, ...SMALL, outline: own, settings: { ...side.settings, kernel } });
  await app.openSession({ source: changed(source, outline), target: changed(target, { preset: 'square' }) });
}

withOneBackend('sharpening', (bench) => {
  test(
    'finite elements come first, and a map at rest is that of the boundary integral with an estimate of its error',
    bench.withApp(async (app) => {
      await open(app, { preset: 'l-shape' }, 'integral');
      const sharp = await app.atRest('both sides are sharpened', (stats) => stats.ready && stats.error_estimate !== null);
      assert.deepEqual(kernelsOf(sharp), ['integral', 'integral']);
      assert.ok(sharp.kernels.every((side) => side.unknowns > 100 && !side.sharpening && side.reason === null));
      assert.ok(sharp.error_estimate.omega < 1e-11 && sharp.error_estimate.image < 1e-3, JSON.stringify(sharp.error_estimate));
      await app.shot(`${bench.backend}-sharpened`);
    }),
  );

  test(
    'a dragged point keeps the boundary integral',
    bench.withApp(async (app) => {
      await open(app, { preset: 'l-shape' }, 'integral');
      const { handles, generation } = await app.atRest('both sides are sharpened');
      await app.hold(handles.x1, [handles.x1[0] + 15, handles.x1[1] - 12]);
      const held = await app.until('the map has followed', (stats, before) => stats.generation > before, generation);
      assert.deepEqual(kernelsOf(held), ['integral', 'integral']);
      await app.letGo();
      const released = await app.atRest('it is at rest');
      assert.deepEqual(kernelsOf(released), ['integral', 'integral']);
      assert.ok(released.error_estimate.omega < 1e-9);
    }),
  );

  test(
    'a session with finite elements stays as it is, in its link too',
    bench.withApp(async (app) => {
      const first = await app.otherAddress(bench.address());
      await open(app, { preset: 'l-shape' }, 'adjoint');
      const stats = await app.atRest('the map is shown');
      assert.deepEqual(kernelsOf(stats), ['adjoint', 'adjoint']);
      assert.equal(stats.error_estimate, null);
      const address = await app.otherAddress(first);
      const other = await bench.open(address);
      await other.during(async () => {
        const opened = await other.stats();
        assert.deepEqual(kernelsOf(opened), ['adjoint', 'adjoint']);
        assert.equal(opened.boundary_checksum, stats.boundary_checksum);
      });
    }),
  );

  test(
    'a map is the same to the last bit however it was come to',
    bench.withApp(async (app) => {
      await open(app, { preset: 'l-shape' }, 'integral');
      const there = await app.atRest('both sides are sharpened');
      await open(app, { preset: 'disk' }, 'integral');
      const elsewhere = await app.atRest('another outline is sharpened');
      assert.notEqual(elsewhere.boundary_checksum, there.boundary_checksum);
      await open(app, { preset: 'l-shape' }, 'integral');
      assert.equal((await app.atRest('the first one again')).boundary_checksum, there.boundary_checksum);
    }),
  );

  test(
    'an outline with too many corners stays with finite elements, and says why',
    bench.withApp(async (app) => {
      const corner = (k) => [Math.cos((k * Math.PI) / 800), Math.sin((k * Math.PI) / 800)].map((x) => x * (1 + (k % 2) / 10));
      const lines = Array.from({ length: 1600 }, (_, k) => corner(k).join(','));
      await app.loadOutline('source', 'gear.csv', `${lines.join('\n')}\n`);
      const stats = await app.atRest('the gear is shown', (now) => now.ready && now.kernels[0]?.reason !== null);
      assert.equal(stats.kernels[0].kernel, 'adjoint');
      assert.match(stats.kernels[0].reason, /unknowns/);
      assert.equal(stats.error_estimate, null);
    }),
  );
});
