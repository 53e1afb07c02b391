// The own picture over the outline: placed by numbers, by dragging and by scrolling, with undo; decimals in German.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { withOneBackend } from './backends.mjs';

/** Runs in the page: drops a picture with a frame and a dot on the source. */
async function dropPicture() {
  const picture = new OffscreenCanvas(160, 120);
  const context = picture.getContext('2d');
  context.fillStyle = 'rgb(70, 120, 200)';
  context.fillRect(0, 0, 160, 120);
  context.fillStyle = 'rgb(250, 210, 60)';
  context.fillRect(10, 10, 50, 40);
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([await picture.convertToBlob()], 'own.png'));
  const canvas = document.querySelector('canvas');
  for (const type of ['dragenter', 'dragover', 'drop']) {
    canvas.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, clientX: 500, clientY: 400, dataTransfer }));
  }
}

const placement = async (app) => (await app.session()).picture ?? { middle: [0, 0], size: 1, turn: 0 };

/** Types into the field that has the focus. */
async function typed(app, text) {
  await app.press('Control+a');
  await app.page.keyboard.type(text);
  await app.press('Enter');
}

async function shown(app) {
  await app.page.evaluate(dropPicture);
  return app.atRest('the picture is the texture', (stats) => stats.ready && stats.image === 'own.png');
}

withOneBackend('the placed picture', (bench) => {
  test(
    'numbers, a drag and the wheel move it, and undo goes back through them',
    bench.withApp(async (app) => {
      const { undo, handles } = await shown(app);
      const apart = [handles.x1[0] - 60, handles.x1[1] - 40];
      await app.walkTo(/^Across, slider/);
      await typed(app, '12.5');
      await app.until('a step', (stats, last) => stats.ready && stats.undo === last + 1, undo);
      assert.deepEqual((await placement(app)).middle, [0.125, 0]);

      await app.walkTo(/^Move it in the picture, check box/);
      await app.press('Space');
      await app.drag(apart, [apart[0] + 50, apart[1] - 30]);
      await app.until('a step of the drag', (stats, last) => stats.ready && stats.undo === last + 2, undo);
      const dragged = await placement(app);
      assert.ok(dragged.middle[0] > 0.15 && dragged.middle[1] > 0.02, `${dragged.middle}`);
      assert.deepEqual([dragged.size, dragged.turn], [1, 0]);
      await app.shot('placed');

      await app.page.mouse.wheel(0, -200);
      await app.until('a step of the wheel', (stats, last) => stats.ready && stats.undo > last + 2, undo);

      await app.walkTo(/^Show the whole picture, button/);
      const scaled = await placement(app); // the wheel's movement is smoothed over frames, which have passed
      assert.ok(scaled.size > 1.01, `${scaled.size}`);
      await app.press('Space');
      await app.until('the whole picture', (stats) => stats.ready);
      assert.deepEqual(await placement(app), { middle: [0, 0], size: 1, turn: 0 });
      await app.press('Escape');
      await app.press('Control+z');
      await app.until('as it was scaled', () => window.riemap.session().picture?.size > 1.01);
      assert.deepEqual(await placement(app), scaled);
    }),
  );

  test(
    'in German a field takes a comma and a point',
    bench.withApp(
      async (app) => {
        await shown(app);
        for (const [text, middle] of [['12,5', 0.125], ['-7.5', -0.075]]) {
          await app.walkTo(/^Rechts, /);
          await typed(app, text);
          await app.until(text, (stats, wanted) => Math.abs((window.riemap.session().picture?.middle[0] ?? 0) - wanted) < 1e-12, middle);
        }
        await app.shot('placed-german');
      },
      { locale: 'de-DE' },
    ),
  );
});
