// One running app: how a person's hands and eyes reach it, in states and not in time.

import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';

const DESKTOP = { viewport: { width: 1440, height: 900 } };
const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
export const DEVICES = { desktop: DESKTOP, phone: PHONE };

/** Software drawing on two busy cores; a state that takes longer is not reached at all. */
const PATIENCE_MS = 60_000;

/** The app on one page. Errors that nobody caught are kept, and `during` fails on them. */
export class App {
  #context;
  #page;
  #faults = [];

  /** `prepare` runs in the page before its own scripts. */
  static async open(browser, address, device, prepare) {
    const context = await browser.newContext(device);
    const app = new App(context, await context.newPage());
    if (prepare) await app.#page.addInitScript(prepare);
    await app.#page.goto(address);
    return app;
  }

  constructor(context, page) {
    this.#context = context;
    this.#page = page;
    page.setDefaultTimeout(PATIENCE_MS);
    page.on('pageerror', (error) => this.#giveUp(`uncaught: ${error.stack ?? error}`));
    page.on('crash', () => this.#giveUp('the page crashed'));
    page.on('requestfailed', (request) => {
      // a reload gives up what is still on its way, such as the icon
      if (request.failure()?.errorText !== 'net::ERR_ABORTED') this.#faults.push(`not loaded: ${request.url()}`);
    });
    page.on('console', (message) => {
      const graphics = message.type() === 'warning' && /WebGL: |WebGPU|validation/i.test(message.text());
      if (message.type() === 'error' || graphics) this.#faults.push(`console: ${message.text()} (${message.location().url})`);
    });
  }

  /** After an uncaught error no state is reached any more: closing the page ends every wait. */
  #giveUp(fault) {
    this.#faults.push(fault);
    return this.#page.close();
  }

  /** Lets `act` use the app, then closes it; fails if anything went wrong in front of or behind the scenes. */
  async during(act) {
    try {
      await this.until('a first map is shown', (stats) => stats.ready);
      await act();
    } catch (error) {
      throw this.#faults.length === 0 ? error : new Error(this.#faults.join('\n'), { cause: error });
    } finally {
      await this.#context.close();
    }
    assert.deepEqual(this.#faults, [], 'nothing goes wrong behind the scenes');
  }

  /** The page itself, for what is not the app. */
  get page() {
    return this.#page;
  }

  stats() {
    return this.#page.evaluate(() => window.riemap.stats());
  }

  session() {
    return this.#page.evaluate(() => window.riemap.session());
  }

  /** Shows the present session with some fields changed. */
  async openSession(changes) {
    const refusal = await this.#page.evaluate(
      (changed) => window.riemap.open_session({ ...window.riemap.session(), ...changed }),
      changes,
    );
    assert.equal(refusal, null, 'the session is taken');
  }

  /** What `riemap.open_session` says of something that is no session. */
  refusalOf(value) {
    return this.#page.evaluate((given) => window.riemap.open_session(given), value);
  }

  /** Waits until `reached(stats, argument)`, asked once a frame in the page, and returns the stats. */
  async until(state, reached, argument) {
    // a function, as the page's policy lets no text be evaluated between the frames
    const body = `const stats = window.riemap?.stats?.(); return stats && (${reached})(stats, argument) ? stats : null;`;
    try {
      const handle = await this.#page.waitForFunction(new Function('argument', body), argument ?? null);
      return await handle.jsonValue();
    } catch (error) {
      const last = await this.#page.evaluate(() => JSON.stringify(window.riemap?.stats?.())).catch(String);
      throw new Error(`not reached: ${state}\nlast stats: ${last}`, { cause: error });
    }
  }

  /** Two animation frames: the app has seen what was done, and drawn it. */
  #frames() {
    return this.#page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /** Drags with the mouse, one step a frame, as a hand would. */
  async drag(from, to, steps = 4) {
    const { mouse } = this.#page;
    await mouse.move(...from);
    await this.#frames();
    await mouse.down();
    await this.#frames();
    for (const point of between(from, to, steps)) {
      await mouse.move(...point);
      await this.#frames();
    }
    await mouse.up();
    await this.#frames();
  }

  /** Moves the pointer there. */
  async pointAt(at) {
    await this.#page.mouse.move(...at);
    await this.#frames();
  }

  /** Clicks, at once: a press that lasts longer than 0.8 s, as slow frames can make it, is no click. */
  async click(at) {
    await this.pointAt(at);
    await this.#page.mouse.click(...at);
    await this.#frames();
  }

  /** Drags with the mouse and does not let go. */
  async hold(from, to, steps = 4) {
    await this.pointAt(from);
    await this.#page.mouse.down();
    await this.#frames();
    for (const point of between(from, to, steps)) await this.pointAt(point);
  }

  /** Lets go of what is held. */
  async letGo() {
    await this.#page.mouse.up();
    await this.#frames();
  }

  /** Pastes a text, as the browser does on Ctrl+V. */
  async pasteText(text) {
    await this.#page.evaluate((pasted) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text', pasted);
      const paste = new ClipboardEvent('paste', { bubbles: true, cancelable: true, clipboardData });
      (document.activeElement ?? document.querySelector('canvas')).dispatchEvent(paste);
    }, text);
    await this.#frames();
  }

  /** Drags with one finger. */
  async touchDrag(from, to, steps = 4) {
    const protocol = await this.#context.newCDPSession(this.#page);
    const touch = async (type, touchPoints) => {
      await protocol.send('Input.dispatchTouchEvent', { type, touchPoints });
      await this.#frames();
    };
    await touch('touchStart', [{ x: from[0], y: from[1] }]);
    for (const [x, y] of between(from, to, steps)) await touch('touchMove', [{ x, y }]);
    await touch('touchEnd', []);
  }

  loadOutline(side, name, text) {
    return this.#page.evaluate((given) => window.riemap.load_outline(...given), [side, name, text]);
  }

  /** Opens a file of any kind, given as bytes in base64. */
  loadFile(side, name, base64) {
    return this.#page.evaluate(
      ([where, called, text]) => window.riemap.load_file(where, called, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))),
      [side, name, base64],
    );
  }

  /** The page's address. */
  address() {
    return this.#page.url();
  }

  /** Loads the page again, and waits for its map. */
  async reload() {
    await this.#page.reload();
    return this.until('a map is shown again', (stats) => stats.ready);
  }

  /** Waits until the address has another fragment than `before`, and returns it. */
  async otherAddress(before) {
    await this.#page.waitForFunction((old) => window.location.href !== old, before);
    return this.address();
  }

  /** Goes to another fragment, as a person does who pastes a link into the address bar. */
  paste(fragment) {
    return this.#page.evaluate((hash) => (window.location.hash = hash), fragment);
  }

  /** Presses keys together, such as "Control+z". */
  async press(keys) {
    await this.#page.keyboard.press(keys);
    await this.#frames();
  }

  /** Walks with the Tab key until a control is said that matches, as someone does who does not see the screen. */
  async walkTo(control, furthest = 150) {
    const heard = [];
    for (let step = 0; step < furthest; step++) {
      const { spoken } = await this.stats();
      await this.#page.keyboard.press(step === 0 ? 'F6' : 'Tab');
      await this.until('another control is said', (stats, before) => stats.spoken > before, spoken);
      heard.push(await this.#page.textContent('#spoken'));
      if (control.test(heard.at(-1))) return this.#frames(); // nobody presses the next key within a frame
    }
    throw new Error(`no control ${control} among: ${heard.join(' | ')}`);
  }

  /** Waits until the page says something that matches in one of its regions, other than `before`, and returns it. */
  async saying(region, words, before = null) {
    const says = ([id, source, old]) => {
      const text = document.getElementById(id)?.textContent ?? '';
      return text !== old && new RegExp(source, 'u').test(text) ? text : null;
    };
    try {
      return await (await this.#page.waitForFunction(says, [region, words.source, before])).jsonValue();
    } catch (error) {
      throw new Error(`not said: ${words}, but: ${await this.#page.textContent(`#${region}`)}`, { cause: error });
    }
  }

  /** The language that the page says it speaks. */
  language() {
    return this.#page.getAttribute('html', 'lang');
  }

  /** Makes the system light or dark. */
  prefer(colorScheme) {
    return this.#page.emulateMedia({ colorScheme });
  }

  /** Presses keys, and returns the file that the browser downloads then. */
  async downloadBy(keys) {
    const coming = this.#page.waitForEvent('download');
    await this.press(keys);
    return contentOf(await coming);
  }

  /** Clicks at a place of the window, and returns the file that the browser downloads then. */
  async download(at) {
    const { mouse } = this.#page;
    await mouse.move(...at);
    await this.#frames();
    const coming = this.#page.waitForEvent('download');
    // at once: a press that lasts longer than 0.8 s, as slow frames can make it, is no click
    await mouse.click(...at);
    return contentOf(await coming);
  }

  /** Writes into the number at a place of the window. */
  async type(at, text) {
    await this.click(at);
    await this.press('Control+a');
    await this.#page.keyboard.type(text);
    await this.press('Enter');
  }

  /** The red, green, blue and alpha of some pixels of a PNG. */
  pixelsOf(png, places) {
    return this.#page.evaluate(
      async ([base64, wanted]) => {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }), { premultiplyAlpha: 'none' });
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
        context.drawImage(bitmap, 0, 0);
        return wanted.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data]);
      },
      [png.toString('base64'), places],
    );
  }

  /** Drops a file on the canvas at a place of the window, as from a file manager. */
  async dropFile(at, name, text) {
    await this.#page.evaluate(
      ([[clientX, clientY], fileName, content]) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([content], fileName));
        const canvas = document.querySelector('canvas');
        for (const type of ['dragenter', 'dragover', 'drop']) {
          canvas.dispatchEvent(
            new DragEvent(type, { bubbles: true, cancelable: true, clientX, clientY, dataTransfer }),
          );
        }
      },
      [at, name, text],
    );
    await this.#frames();
  }

  /** Takes a picture, keeps it in the folder `RIEMAP_SHOTS` if that is set, and returns its colours' counts. */
  async picture(name) {
    await this.#frames();
    const folder = process.env.RIEMAP_SHOTS;
    if (folder) mkdirSync(folder, { recursive: true });
    const png = await this.#page.screenshot(folder ? { path: join(folder, `${name}.png`) } : {});
    return this.#page.evaluate(countColours, png.toString('base64'));
  }
}

async function contentOf(download) {
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
}

function between(from, to, steps) {
  return Array.from({ length: steps }, (_, k) => from.map((start, axis) => start + ((to[axis] - start) * (k + 1)) / steps));
}

/** Runs in the page: how many pixels each colour has, the most frequent first, in steps of 16. */
async function countColours(png) {
  const bytes = Uint8Array.from(atob(png), (c) => c.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  const counts = new Map();
  for (let k = 0; k < data.length; k += 4) {
    const colour = (data[k] >> 4) * 256 + (data[k + 1] >> 4) * 16 + (data[k + 2] >> 4);
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  return [...counts.values()].sort((a, b) => b - a);
}
