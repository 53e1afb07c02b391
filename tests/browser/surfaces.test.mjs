// Surfaces in the release web app: prepared by a worker, drawn in space, dragged, colored, rejected.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withEachBackend, withOneBackend } from './backends.mjs';

const surface = (preset, boundary) => ({ spec: { shape: { preset: { preset, boundary } } } });

/**
 * A square of n × n cells, bent into a wave, as OBJ; if `loose` with a triangle that names a vertex of its own once and
 * another one twice, with inner vertices displaced by up to a fifth of a cell if `rough`.
 */
function wave(n, { loose = false, rough = false } = {}) {
  const lines = loose ? ['v 9 9 9'] : [];
  const off = (i, j) => (rough && i % n && j % n ? (((i * 7919 + j * 104_729) % 601) - 300) / 1500 : 0);
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) {
      const [x, y] = [(i + off(i, j)) / n, (j + off(j, i)) / n];
      lines.push(`v ${x} ${y} ${0.2 * Math.sin(6 * x)}`);
    }
  }
  const vertex = (i, j) => (loose ? 2 : 1) + j * (n + 1) + i;
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) lines.push(`f ${vertex(i, j)} ${vertex(i + 1, j)} ${vertex(i + 1, j + 1)} ${vertex(i, j + 1)}`);
  }
  if (loose) lines.push('f 1 2 2');
  return Buffer.from(`${lines.join('\n')}\n`);
}

/** A square of 6 × 6 cells in space with two holes, of two cells and of one, as OBJ. */
function holed() {
  const lines = [];
  for (let j = 0; j <= 6; j++) for (let i = 0; i <= 6; i++) lines.push(`v ${i} ${j} ${Math.sin(i) * Math.cos(j)}`);
  const vertex = (i, j) => 1 + 7 * j + i;
  const isHole = (i, j) => (j === 1 && (i === 1 || i === 2)) || (i === 4 && j === 4);
  for (let j = 0; j < 6; j++) {
    for (let i = 0; i < 6; i++) {
      if (!isHole(i, j)) lines.push(`f ${vertex(i, j)} ${vertex(i + 1, j)} ${vertex(i + 1, j + 1)} ${vertex(i, j + 1)}`);
    }
  }
  return Buffer.from(`${lines.join('\n')}\n`);
}

/** Replaces the target by a preset. */
async function show(app, preset, boundary, changes = {}) {
  const { generation } = await app.stats();
  await app.openSession({ surface: surface(preset, boundary), ...changes });
  return app.atRest(
    'the surface is mapped',
    (stats, last) => stats.ready && stats.surface_ms !== null && stats.generation > last,
    generation,
  );
}

withEachBackend('surfaces', (bench) => {
  const { backend } = bench;

  test(
    'a surface is mapped to the outline, and its dots are dragged in space',
    bench.withApp(async (app) => {
      const shown = await show(app, 'animal-head', 250);
      assert.equal(shown.target.m, 250);
      assert.equal(shown.flipped, 0);
      assert.ok(shown.q_mean < 1.2, `nearly conformal: mean Q = ${shown.q_mean}`);
      assertShowsSomething(await app.picture(`${backend}-surface`));
      assertMapsPoint(shown);
      for (const [handle, by] of Object.entries({ x1: [20, -25], x2: [-30, 40], y1: [40, 60] })) {
        const { generation, boundary_checksum, handles } = await app.stats();
        await app.drag(handles[handle], handles[handle].map((value, axis) => value + by[axis]));
        const moved = await app.atRest(
          `the map has followed ${handle}`,
          (stats, last) => stats.ready && stats.generation > last.generation && stats.boundary_checksum !== last.boundary_checksum,
          { generation, boundary_checksum },
        );
        const [x, y] = handles[handle];
        assert.ok(Math.hypot(moved.handles[handle][0] - x, moved.handles[handle][1] - y) > 10, `${handle} has moved`);
        assertMapsPoint(moved);
      }
    }),
  );

  for (const [sides, surfaces] of Object.entries({
    'the source': { source: surface('half-torus', 100) },
    'both sides': { source: surface('hemisphere', 100), target: surface('animal-head', 120) },
  })) {
    test(
      `a surface on ${sides} is mapped, dragged, and kept in the address`,
      bench.withApp(async (app) => {
        const { generation } = await app.stats();
        await app.openSession(await ofVersion2(app, surfaces));
        const is_there = (stats, last) => stats.ready && stats.surface_ms !== null && stats.generation > last;
        const shown = await app.atRest('it is mapped', is_there, generation);
        assert.deepEqual([shown.errors, shown.flipped, shown.source.m], [[], 0, 100]);
        assertShowsSomething(await app.picture(`${backend}-surface-on-${sides.replaceAll(' ', '-')}`));
        assertMapsPoint(shown);
        for (const handle of Object.keys(surfaces).map((side) => (side === 'source' ? 'x1' : 'x2'))) {
          const before = await app.stats();
          const [x, y] = before.handles[handle];
          await app.drag([x, y], [x + 25, y + 20]);
          const moved = await app.atRest(`the map has followed ${handle}`, is_there, before.generation);
          assert.ok(Math.hypot(moved.handles[handle][0] - x, moved.handles[handle][1] - y) > 10, `${handle} has moved`);
          assertMapsPoint(moved);
        }
        await app.until('the address has it', () => window.location.hash === window.riemap.link());
        const session = await app.session();
        assert.equal(session.version, 2);
        await app.reload();
        await app.until('it is there again', (stats) => stats.ready && stats.surface_ms !== null && stats.source.m === 100);
        assert.deepEqual(await app.session(), session);
      }),
    );
  }

  const modes = {
    'angle distortion with the mesh': { colouring: 'angle', wireframe: true },
    'area distortion': { colouring: 'area' },
    'the conformal polar grid and the plots': { texture: 'conformal', plots: true },
  };
  for (const [mode, changes] of Object.entries(modes)) {
    test(
      `${mode} of a surface`,
      bench.withApp(async (app) => {
        const shown = await show(app, 'half-torus', 150, changes);
        assert.deepEqual(shown.errors, []);
        assertShowsSomething(await app.picture(`${backend}-surface-${mode.replaceAll(' ', '-')}`));
      }),
    );
  }
});

withOneBackend('surfaces, however they are drawn', (bench) => {
  const { backend } = bench;

  test(
    'a drag beside the dots turns the surface and leaves the map',
    bench.withApp(async (app) => {
      const before = await show(app, 'hemisphere', 120);
      const [x, y] = before.handles.x2;
      await app.drag([x + 80, y + 90], [x - 40, y + 60]);
      const after = await app.until(
        'the dot is elsewhere',
        (stats, last) => Math.hypot(stats.handles.x2[0] - last[0], stats.handles.x2[1] - last[1]) > 5,
        before.handles.x2,
      );
      assert.equal(after.boundary_checksum, before.boundary_checksum);
      assertShowsSomething(await app.picture(`${backend}-surface-turned`));
    }),
  );

  test(
    'a surface on a phone',
    bench.withApp(
      async (app) => {
        const { handles, boundary_checksum } = await show(app, 'height-field', 120);
        await app.touchDrag(handles.x2, [handles.x2[0] + 20, handles.x2[1] + 15]);
        await app.until(
          'the map has followed the finger',
          (stats, last) => stats.ready && stats.boundary_checksum !== last,
          boundary_checksum,
        );
        assertShowsSomething(await app.picture(`${backend}-surface-phone`));
      },
      { device: 'phone' },
    ),
  );

  test(
    'a surface in a file is mapped, a broken one is refused with the reason, and the plane comes back',
    bench.withApp(async (app) => {
      await app.loadFile('target', 'wave.obj', wave(20));
      const mapped = await app.until('the file is mapped', (stats) => stats.ready && stats.target.triangles === 800);
      assert.ok(mapped.notes.some((note) => note.includes('400 polygons')), 'the note about polygons');
      assertMapsPoint(mapped);
      await app.loadFile('target', 'loose.obj', wave(20, { loose: true }));
      const refused = await app.until('an error is shown', (stats) => stats.errors.length > 0);
      assert.match(refused.errors.join(' '), /loose\.obj: triangle 800 \[0, 1, 1\] names a vertex twice/);
      assert.equal(refused.boundary_checksum, mapped.boundary_checksum, 'the last good map stays');
      assertShowsSomething(await app.picture(`${backend}-surface-refused`));
      await app.walkTo(/^Repair it, button/);
      await app.press('Space');
      const repaired = await app.until(
        'it is repaired, and what was done is said',
        (stats) => stats.ready && stats.errors.length === 0 && /1 vertex in no triangle was dropped/.test(stats.notes.join()),
      );
      assert.equal(repaired.target.triangles, 800);
      await app.openSession({ surface: null });
      const planar = await app.until('the plane is back', (stats) => stats.ready && stats.surface_ms === null);
      assert.ok(planar.target.triangles !== 800);
    }),
  );

  test(
    'any boundary loop becomes the outline, by a click in the picture or in the list, and holes can stay open',
    bench.withApp(async (app) => {
      await app.loadFile('target', 'holed.obj', holed());
      const refused = await app.until('an error is shown', (stats) => stats.errors.length > 0);
      assert.match(refused.errors.join(' '), /3 boundary loops/);
      await app.walkTo(/^Repair it, button/);
      await app.press('Space');
      const around = (m) => app.atRest(`the outline has ${m} vertices`, (stats, count) => stats.ready && stats.target.m === count, m);
      const repaired = await around(24);
      assert.equal(repaired.loops[1].length, 3);
      assertShowsSomething(await app.picture(`${backend}-surface-loops`));
      await app.click(repaired.loops[1][1]);
      await around(6);
      assertShowsSomething(await app.picture(`${backend}-surface-loops-second`));
      await app.walkTo(/^1: length/);
      await app.press('Space');
      const { triangles } = await around(24);
      await app.walkTo(/^Open, choice/);
      await app.press('Space');
      const open = await app.atRest('the holes are open', (stats, all) => stats.ready && stats.triangles < all, triangles);
      assert.equal(triangles - open.triangles, 10, 'a fan in each hole');
      assert.ok(open.notes.some((note) => note.includes('open in the picture')), open.notes.join());
      assertShowsSomething(await app.picture(`${backend}-surface-loops-open`));
      const session = await app.session();
      assert.equal(session.target.surface.holes, 'open');
      await app.reload();
      await app.atRest('it is there again', (stats, count) => stats.ready && stats.triangles === count, open.triangles);
      assert.deepEqual(await app.session(), session);
      await app.press('Control+z');
      await app.atRest('the holes are filled again', (stats, all) => stats.ready && stats.triangles === all, triangles);
    }),
  );

  test(
    'a surface of 30,000 triangles is mapped, and its dot is dragged',
    bench.withApp(async (app) => {
      await app.loadFile('target', 'rough.obj', wave(122, { rough: true }));
      const shown = await app.atRest('it is mapped', (stats) => stats.ready && stats.surface_ms !== null);
      assert.deepEqual([shown.target.m, shown.target.triangles], [488, 29_768]);
      assert.deepEqual(shown.errors, []);
      // the triangle at the surface's corner has three vertices on the boundary, and may lie on a concave arc
      assert.ok(shown.flipped <= 1, `${shown.flipped} triangles are flipped`);
      // that triangle, flat on the outline, alone adds 0.14 to the mean
      assert.ok(shown.q_mean < 1.25, `nearly conformal: mean Q = ${shown.q_mean}`);
      assertMapsPoint(shown);
      const { x2 } = shown.handles;
      await app.drag(x2, [x2[0] + 30, x2[1] - 20]);
      const moved = await app.atRest(
        'the map has followed',
        (stats, last) => stats.ready && stats.boundary_checksum !== last,
        shown.boundary_checksum,
      );
      assert.ok(Math.hypot(moved.handles.x2[0] - x2[0], moved.handles.x2[1] - x2[1]) > 10, 'the dot has moved');
      assertMapsPoint(moved);
      assertShowsSomething(await app.picture(`${backend}-surface-large`));
    }),
  );

  test(
    'the figures with surfaces are opened from their menu',
    bench.withApp(async (app) => {
      for (const [scene, preset] of [
        [/^sixths to corners, button/, 'hemisphere'],
        [/^x₁ = 0, button/, 'animal-head'],
        [/^Maple leaf, button/, 'height-field'],
      ]) {
        await app.walkTo(/^Figures, button/);
        await app.press('Space');
        await app.walkTo(scene);
        const { generation } = await app.stats();
        await app.press('Enter');
        await app.until(
          'the surface is mapped',
          (stats, last) => stats.ready && stats.surface_ms !== null && stats.generation > last,
          generation,
        );
        assert.equal((await app.session()).surface.spec.shape.preset.preset, preset);
        assertShowsSomething(await app.picture(`${backend}-figure-with-the-${preset}`));
      }
    }),
  );
});

/** Returns the app's session with these surfaces, by side, as an object of version 2. */
async function ofVersion2(app, surfaces) {
  const { source, target, interior, anchor } = await app.session();
  const side = (outline, k, name) => ({ ...outline, interior: interior[k], anchor: anchor[k], surface: surfaces[name] ?? null });
  return { version: 2, source: side(source, 0, 'source'), target: side(target, 1, 'target') };
}

/** Checks the constraint on the interior points: the mapped side's point is mapped to the other side's. */
function assertMapsPoint({ image_of_mapped_point: image, expected }) {
  const distance = Math.hypot(image[0] - expected[0], image[1] - expected[1]);
  assert.ok(distance < 0.03, `image ${image}, expected ${expected}, distance ${distance}`);
}

function assertShowsSomething(colours) {
  const most = colours[0] / colours.reduce((sum, count) => sum + count, 0);
  assert.ok(colours.length > 30, `only ${colours.length} colours`);
  assert.ok(most < 0.9, `${(100 * most).toFixed(0)} % of the picture has one colour`);
}
