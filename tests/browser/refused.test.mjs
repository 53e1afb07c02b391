// A surface that cannot be opened: the picture with its faults in red, by keyboard and pointer, until it is repaired.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** The height of the status line, with its edge. */
const STATUS = 28;

/** A square of n × n cells with a triangle more on one of its inner edges, which then has three, as OBJ. */
function finned(n) {
  const vertex = (i, j) => 1 + j * (n + 1) + i;
  const [vertices, faces] = [[], []];
  for (let j = 0; j <= n; j++) for (let i = 0; i <= n; i++) vertices.push(`v ${i} ${j} ${0.3 * Math.sin(i)}`);
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) faces.push([vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]);
  }
  const [a, b, tip] = [vertex(2, 2), vertex(3, 2), (n + 1) ** 2 + 1];
  vertices.push('v 2.5 2 1.5');
  faces.push([a, b, tip]);
  return Buffer.from([...vertices, ...faces.map((face) => `f ${face.join(' ')}`), ''].join('\n'));
}

/**
 * Runs in the page: the box [left, top, right, bottom] around the pixels in which two screenshots differ, in points, and
 * how many of those pixels are red in the second one.
 */
async function difference([first, second]) {
  const pixels = async (png) => {
    const bytes = Uint8Array.from(atob(png), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height);
  };
  const [before, after] = [await pixels(first), await pixels(second)];
  const found = { box: [Infinity, Infinity, -Infinity, -Infinity], red: 0 };
  for (let k = 0; k < after.data.length; k += 4) {
    const off = [0, 1, 2].map((c) => Math.abs(after.data[k + c] - before.data[k + c]));
    if (Math.max(...off) < 24) continue;
    const [x, y] = [(k / 4) % after.width, Math.floor(k / 4 / after.width)];
    found.box = [Math.min(found.box[0], x), Math.min(found.box[1], y), Math.max(found.box[2], x), Math.max(found.box[3], y)];
    const [r, g, b] = after.data.subarray(k, k + 3);
    if (r > g + 60 && r > b + 60) found.red++;
  }
  found.box = found.box.map((pixel) => pixel / devicePixelRatio);
  return found;
}

withOneBackend('refused surfaces', (bench) => {
  /** The screen above the status line, which says how long a frame takes. */
  const seen = async (app) => {
    const { width, height } = app.page.viewportSize();
    return (await app.screenshot({ clip: { x: 0, y: 0, width, height: height - STATUS } })).toString('base64');
  };

  /** What `act` changes on the screen, which is at rest before and after. */
  async function changed(app, act) {
    await app.atRest('before');
    const before = await seen(app);
    await act();
    await app.atRest('after');
    return app.page.evaluate(difference, [before, await seen(app)]);
  }

  for (const device of ['desktop', 'phone']) {
    test(
      `the faults are marked in red in a picture that the arrow keys and a drag turn, on a ${device}`,
      bench.withApp(
        async (app) => {
          const planar = await app.stats();
          await app.loadFile('target', 'fin.obj', finned(6));
          const { errors, boundary_checksum } = await app.until('it is refused', (stats) => stats.errors.length > 0);
          assert.match(errors.join(' '), /fin\.obj.*edge.*triangles/);
          assert.equal(boundary_checksum, planar.boundary_checksum, 'the last good map stays');
          await app.walkTo(/faults in red \(1\)/);
          await app.shot(`refused-${device}`);
          const turned = await changed(app, async () => {
            for (let k = 0; k < 4; k++) await app.press('ArrowRight');
          });
          const [left, top, right, bottom] = turned.box;
          assert.ok(turned.red > 5, `${turned.red} red pixels have moved`);
          assert.ok(right - left < 330 && bottom - top < 230, `only the picture has changed: ${turned.box}`);
          const middle = [(left + right) / 2, (top + bottom) / 2];
          const { generation } = await app.stats();
          const dragged = await changed(app, () => app.drag(middle, [middle[0] + 30, middle[1] + 12]));
          assert.ok(dragged.red > 5, `${dragged.red} red pixels have moved`);
          assert.equal((await app.stats()).generation, generation, 'the map is not dragged');
          await app.walkTo(/^Close this message, button/);
          await app.press('Space');
          await app.until('the message is gone', (stats) => stats.errors.length === 0);
          await assert.rejects(app.walkTo(/faults in red/, 60), /no control/);
        },
        { device },
      ),
    );
  }
});
