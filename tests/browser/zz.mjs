import { launch } from './chromium.mjs'; import { serve } from './server.mjs';
const dists = process.argv.slice(2);
const sizes = (process.env.S ?? '1440x900,800x600,420x360').split(',').map((s) => s.split('x').map(Number));
const backends = (process.env.B ?? 'WebGL2').split(',');
for (const backend of backends) { const browser = await launch(backend);
 for (const [w, h] of sizes) for (const dist of dists) { const site = await serve(dist);
  const page = await browser.newPage({ viewport: { width: w, height: h } });
  await page.addInitScript(() => { const P = WebGL2RenderingContext.prototype; for (const n of ['drawElements','drawArrays','drawElementsInstanced','drawArraysInstanced','blitFramebuffer']) { const o = P[n]; P[n] = function (...a) { if (!window.nodraw) return o.apply(this, a); }; } });
  await page.goto(site.address); await page.waitForFunction(() => window.riemap?.stats?.()?.ready, null, { timeout: 120000 }); await page.waitForTimeout(2500);
  await page.mouse.click(w / 4, h / 2 + 5); await page.keyboard.press('e'); await page.waitForFunction(() => window.riemap.stats().editing?.handles?.length > 0, null, { timeout: 20000 }); await page.waitForTimeout(1500);
  const editing = await page.evaluate(() => window.riemap.stats().editing);
  const handles = editing.handles; const at = handles[Math.floor(handles.length / 3)];
  if (process.env.V) console.log(JSON.stringify(editing).slice(0, 200), at);
  await page.mouse.move(Math.round(at[0]), Math.round(at[1])); await page.waitForTimeout(800); await page.mouse.down(); await page.waitForTimeout(800);
  const r = await page.evaluate(async ([x, y, nodraw]) => { window.nodraw = nodraw; const c = document.querySelector('canvas'); let k = 0; const ts = []; const seen = new Set(); const begin = performance.now();
    const run = (ms) => new Promise((done) => { const t0 = performance.now(); const step = (t) => { ts.push(t); seen.add(window.riemap.stats().generation); const a = 0.35 * k++; c.dispatchEvent(new MouseEvent('mousemove', { bubbles: true, buttons: 1, clientX: Math.round(x + 6 * Math.cos(a)), clientY: Math.round(y + 6 * Math.sin(a)) })); if (performance.now() - t0 < ms) requestAnimationFrame(step); else done(); }; requestAnimationFrame(step); });
    await run(1500); seen.clear(); ts.length = 0; const g0 = window.riemap.stats().generation; const t0 = performance.now(); await run(4000); const dt = (performance.now() - t0) / 1000; window.nodraw = false; return [(window.riemap.stats().generation - g0) / dt, seen.size / dt, ts.length / dt]; }, [at[0], at[1], !!process.env.NODRAW]);
  await page.mouse.up();
  console.log(backend, dist, `${w}x${h}`, process.env.NODRAW ? 'nodraw' : 'drawn', 'generations/s', r[0].toFixed(1), 'seen/s', r[1].toFixed(1), 'frames/s', r[2].toFixed(1));
  await page.close(); await site.close(); }
 await browser.close(); }
process.exit(0);
