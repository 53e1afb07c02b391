// The release web app with each of wgpu's two backends: it starts, follows mouse and touch,
// loads outlines, and reports errors in a bad one while it keeps the last good map.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { SHARP, SHARP_PHONE } from './app.mjs';
import { withEachBackend, withOneBackend } from './backends.mjs';

/** A regular 40-gon, in the simplest format. */
const POLYGON = Array.from({ length: 40 }, (_, k) => {
  const angle = (2 * Math.PI * k) / 40;
  return `${Math.cos(angle)},${Math.sin(angle)}`;
}).join('\n');
/** A polygon whose first and third edges cross. */
const BOW_TIE = '0,0\n1,1\n1,0\n0,1\n';

/** Display settings of a session, and how the stats show that they are in effect. */
const MODES = {
  'the plots': { changes: { plots: true }, reached: (stats) => stats.plots },
  'angle distortion with the mesh': {
    changes: { colouring: 'angle', wireframe: true },
    reached: (stats) => stats.colouring === 'angle' && stats.wireframe && stats.measured_generation === stats.generation,
  },
  'area distortion': {
    changes: { colouring: 'area', direction: 'forward' },
    reached: (stats) => stats.colouring === 'area' && stats.measured_generation === stats.generation,
  },
  'the Cauchy-Green extension': {
    changes: { extension: 'cauchy-green' },
    reached: (stats, last) =>
      stats.generation > last.generation && stats.cauchy_green !== null && stats.extension_progress === 1,
  },
  'the conformal polar grid': { changes: { texture: 'conformal' }, reached: (stats) => stats.ready },
  'the pattern pulled back': {
    changes: { texture: 'grid', texture_side: 'target' },
    reached: (stats) => stats.ready,
  },
  'the way through the disk': {
    changes: { comparison: 'both', plots: true },
    reached: ({ comparison: { fresh, precomputed } }) =>
      [fresh, precomputed].every((found) => found !== null && found.difference < 0.1),
  },
};

/** In units of the target's size: the error of an image within one triangle of the mesh is smaller. */
const MAPPING_TOLERANCE = 0.02;

/** Next to a corner that moves far, single triangles of a coarse mesh flip. A wrong map flips hundreds. */
const FLIPPED_SHARE = 0.002;

/** The drag of each handle in CSS pixels; boundary points are dragged along the outlines' sides. */
const DRAGS = { x1: [14, -18], x2: [-16, 12], y1: [60, 60], y2: [-90, -40] };

withEachBackend('the app', (bench) => {
  const { backend } = bench;

  test(
    'the app starts with this backend and shows a map',
    bench.withApp(async (app) => {
      assertShowsSomething(await app.picture(`${backend}-desktop`));
      const stats = await app.stats();
      assert.equal(stats.backend, backend);
      assert.deepEqual(stats.errors, []);
      assert.ok(stats.source.triangles > 1000 && stats.target.triangles > 1000, 'both domains are meshed');
      assert.equal(stats.flipped, 0);
      assert.ok(stats.q_mean >= 1 && stats.q_mean < 1.5, `nearly conformal: mean Q = ${stats.q_mean}`);
      assertMapsInteriorPoint(stats);
    }, SHARP),
  );

  test(
    'dragging a handle changes the map',
    bench.withApp(async (app, context) => {
      for (const handle of Object.keys(DRAGS)) {
        await context.test(handle, () => dragChangesMap(app, handle, (from, to) => app.drag(from, to)));
      }
    }),
  );

  test(
    'a finger drags an interior point on a phone',
    bench.withApp(
      async (app) => {
        const { handles } = await app.stats();
        assert.ok(handles.x1, 'the source is on the screen');
        await dragChangesMap(app, 'x1', (from, to) => app.touchDrag(from, to));
        assertShowsSomething(await app.picture(`${backend}-phone`));
      },
      { device: 'phone', ...SHARP_PHONE },
    ),
  );

  for (const [mode, { changes, reached }] of Object.entries(MODES)) {
    test(
      `${mode} is shown`,
      bench.withApp(async (app) => {
        const before = await app.stats();
        await app.openSession(changes);
        const stats = await app.until(mode, reached, { generation: before.generation });
        assert.deepEqual(stats.errors, []);
        assertShowsSomething(await app.picture(`${backend}-${mode.replaceAll(' ', '-')}`));
        for (const [field, value] of Object.entries(changes)) {
          assert.deepEqual((await app.session())[field], value, `the session has the ${field}`);
        }
      }),
    );
  }

  test(
    'a small Cauchy-Green extension comes from the compute shader where there is one',
    bench.withApp(async (app) => {
      const settings = { sampling: { uniform: { count: 120, keep_corners: true } }, sizing: { graded: 0.3 } };
      const { source, target } = await app.session();
      const [coarseSource, coarseTarget] = [source, target].map(({ outline }) => ({ outline, settings }));
      await app.openSession({ source: coarseSource, target: coarseTarget, extension: 'cauchy-green' });
      const stats = await app.until(
        'the extension is complete',
        ({ ready, source: { m }, cauchy_green: by, extension_progress: part }) => ready && m < 200 && by && part === 1,
      );
      assert.equal(stats.cauchy_green, backend === 'WebGPU' ? 'gpu' : 'cpu');
      assert.deepEqual(stats.errors, []);
      assertShowsSomething(await app.picture(`${backend}-small-Cauchy-Green`));
    }),
  );
});

withOneBackend('the app, however it draws', (bench) => {
  test(
    'a touch that the system takes away lets go of the point',
    bench.withApp(
      async (app) => {
        const { handles } = await app.stats();
        await app.touchTakenAway(handles.x1, [handles.x1[0] + 15, handles.x1[1] + 10]);
        await dragChangesMap(app, 'x1', (from, to) => app.touchDrag(from, to));
      },
      { device: 'phone' },
    ),
  );

  test(
    'an outline in a file replaces the source',
    bench.withApp(async (app) => {
      const before = await app.stats();
      await app.loadOutline('source', 'forty.csv', POLYGON);
      await assertReplaced(app, 'source', before);
    }),
  );

  test(
    'an outline chosen in the file dialog replaces the source, and a cancelled dialog changes nothing',
    bench.withApp(async (app) => {
      const [before, session] = [await app.stats(), await app.session()];
      const openFile = async () => {
        await app.walkTo(/^Shapes, button/);
        await app.press('Space');
        await app.walkTo(/^Open a file…, button/);
      };
      await openFile();
      await app.inFileDialog(() => app.press('Enter'));
      assert.deepEqual(await app.session(), session);
      await openFile();
      await app.inFileDialog(() => app.press('Enter'), 'forty.csv', POLYGON);
      await assertReplaced(app, 'source', before);
    }),
  );

  test(
    'an outline dropped on the target replaces it',
    bench.withApp(async (app) => {
      const before = await app.stats();
      await app.dropFile(before.handles.x2, 'forty.csv', POLYGON);
      await assertReplaced(app, 'target', before);
    }),
  );

  test(
    'every way of preparing gives the same map',
    bench.withApp(async (app) => {
      const { source, target } = await app.session();
      // maps from uniform samples are not refined at rest, as those from the table never are
      const sampling = { uniform: { count: 300, keep_corners: true } };
      const prepared = (way) =>
        [source, target].map((domain) => ({ ...domain, settings: { ...domain.settings, sampling, ...way } }));
      const finite = prepared({ kernel: 'adjoint' });
      await app.openSession({ source: finite[0], target: finite[1] });
      const before = await app.until(
        'both sides are prepared with finite elements',
        (stats) => stats.ready && stats.kernels.every((side) => side.kernel === 'adjoint'),
      );
      for (const way of [{ kernel: 'table' }, { kernel: 'adjoint', solver: 'pcg' }]) {
        const domains = prepared(way);
        await app.openSession({ source: domains[0], target: domains[1] });
        const after = await app.until(
          `both sides are prepared anew, ${JSON.stringify(way)}`,
          (stats, hasTable) => stats.ready && stats.prepare_ms.every(({ table }) => table > 0 === hasTable),
          way.kernel === 'table',
        );
        const difference = Math.abs(after.boundary_checksum - before.boundary_checksum);
        assert.ok(difference < 1e-6 * Math.abs(before.boundary_checksum), `${JSON.stringify(way)}: ${difference}`);
      }
    }),
  );

  test(
    'what is no session is refused with the reason',
    bench.withApp(async (app) => {
      const session = await app.session();
      assert.match(await app.refusalOf({ version: 1 }), /missing field/);
      assert.equal(typeof (await app.refusalOf(null)), 'string');
      assert.deepEqual(await app.session(), session);
    }),
  );

  test(
    'a bad outline is refused with a readable reason, and the map stays',
    bench.withApp(async (app) => {
      const before = await app.stats();
      await app.loadOutline('source', 'bow-tie.csv', BOW_TIE);
      const after = await app.until('an error is shown', (stats) => stats.errors.length > 0);
      assertShowsSomething(await app.picture('bad-outline'));
      assert.match(after.errors.join(' '), /cross/i);
      assert.deepEqual(after.source, before.source);
      assert.equal(after.boundary_checksum, before.boundary_checksum);
    }),
  );
});

/** Drags a handle and checks that there is a new map with the new constraints and almost no flipped triangles. */
async function dragChangesMap(app, handle, drag) {
  const before = await app.stats();
  const session = await app.session();
  const from = before.handles[handle];
  await drag(from, from.map((coordinate, axis) => coordinate + DRAGS[handle][axis]));
  const after = await app.atRest(
    'the map has changed, and its own quality is known',
    (stats, last) =>
      stats.ready &&
      stats.generation > last.generation &&
      stats.boundary_checksum !== last.boundary_checksum &&
      stats.measured_generation === stats.generation,
    { generation: before.generation, boundary_checksum: before.boundary_checksum },
  );
  assert.notDeepEqual(await app.session(), session, 'the session holds the new point');
  assert.notDeepEqual(after.handles[handle], before.handles[handle], 'the handle has moved');
  const triangles = Math.min(after.source.triangles, after.target.triangles);
  assert.ok(after.flipped <= FLIPPED_SHARE * triangles, `${after.flipped} of ${triangles} triangles are flipped`);
  assertMapsInteriorPoint(after);
}

/** Checks that the outline of `side` was replaced, prepared and mapped, and that the other side is unchanged. */
async function assertReplaced(app, side, before) {
  const other = side === 'source' ? 'target' : 'source';
  const replaced = await app.until(
    'the new outline is prepared and mapped',
    (stats, last) => stats.ready && stats.generation > last.generation && stats[last.side].n !== last.n,
    { side, generation: before.generation, n: before[side].n },
  );
  assert.deepEqual(replaced.errors, []);
  assert.deepEqual(replaced[other], before[other], `the ${other} is untouched`);
  assertMapsInteriorPoint(replaced);
}

/** Checks the constraint on the interior points: f(x₁) = x₂, or f⁻¹(x₂) = x₁. */
function assertMapsInteriorPoint({ image_of_mapped_point: image, expected }) {
  const distance = Math.hypot(image[0] - expected[0], image[1] - expected[1]);
  const message = `image ${image}, expected ${expected}, distance ${distance}`;
  assert.ok(distance < MAPPING_TOLERANCE, message);
}

/** Checks that the page is not blank: a blank page has one color; the map, its texture and the panels have many. */
function assertShowsSomething(colours) {
  const most = colours[0] / colours.reduce((sum, count) => sum + count, 0);
  assert.ok(colours.length > 30, `only ${colours.length} colours`);
  assert.ok(most < 0.9, `${(100 * most).toFixed(0)} % of the picture has one colour`);
}
