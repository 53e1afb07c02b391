// The map refined at rest in a browser: the full map while something moves, the refined one afterwards.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** A picture may have this share of flipped triangles. */
const FLIPS = 1e-3;

/** Equations that resolve another point as well have other panels, and images that differ by their errors. */
const SAME = 1e-9;

const flips = ({ flipped, triangles }) => flipped / triangles;

/** The present session with these presets at their default points, mapped in this direction. */
async function open(app, presets, direction = 'backward') {
  const session = await app.session();
  const changed = (side, preset) => ({ ...session[side], outline: { preset }, interior: null, anchor: 0 });
  const sides = ['source', 'target'].map((side, k) => [side, changed(side, presets[k])]);
  await app.openSession({ ...Object.fromEntries(sides), direction });
}

/** Waits until the distortion of the map at rest is measured. */
const refined = (app) =>
  app.atRest('the map is refined', (s) => s.ready && s.unresolved_area !== null && s.measured_generation === s.generation);

function isTheSame(now, before) {
  const difference = Math.abs(now.boundary_checksum - before.boundary_checksum);
  assert.ok(difference < SAME, `${now.boundary_checksum}, before ${before.boundary_checksum}`);
  assert.equal(now.triangles, before.triangles);
}

withOneBackend('refining', (bench) => {
  for (const device of ['desktop', 'phone']) {
    test(
      `a map into a crowded domain is drawn without folds at rest, ${device}`,
      bench.withApp(
        async (app) => {
          const mapped = { forward: 'source', backward: 'target' };
          const cases = [['v-shape', 'forward'], ['v-shape', 'backward'], ['star', 'forward'], ['spiral', 'forward']];
          for (const [preset, direction] of cases) {
            await open(app, ['disk', preset], direction);
            const stats = await refined(app);
            const full = stats[mapped[direction]];
            assert.ok(flips(stats) <= FLIPS, `${preset}: ${stats.flipped} of ${stats.triangles}`);
            assert.ok(stats.triangles > full.triangles, `${preset}: ${stats.triangles} of ${full.triangles}`);
            assert.equal(stats.unrefined, null);
            await app.shot(`${bench.backend}-${device}-refined-${preset}-${direction}`);
          }
        },
        { device },
      ),
    );
  }

  test(
    'a drag shows the full map, and rest the refined one, the same however it was come to',
    bench.withApp(async (app) => {
      await open(app, ['disk', 'v-shape'], 'forward');
      const before = await refined(app);
      const { x1 } = before.handles;
      await app.hold(x1, [x1[0] + 40, x1[1] - 30]);
      const held = await app.until('the full map has followed', (now, then) => now.generation > then && now.unresolved_area === null, before.generation);
      assert.ok(!held.ready && held.triangles < before.triangles);
      await app.shot(`${bench.backend}-not-refined`);
      await app.letGo();
      const moved = await refined(app);
      assert.notEqual(moved.boundary_checksum, before.boundary_checksum);
      await app.press('Control+z');
      await app.until('undone', (now, then) => now.generation > then, moved.generation);
      isTheSame(await refined(app), before);
      await open(app, ['heart', 'star']);
      assert.notEqual((await refined(app)).triangles, before.triangles);
      await open(app, ['disk', 'v-shape'], 'forward');
      isTheSame(await refined(app), before);
    }),
  );
});
