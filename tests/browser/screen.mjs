// Leaves the screen blank while nobody looks at it: in software, drawing the window takes most of a frame's time.
// Everything else is done as always, also what is rendered into other textures. WebGPU only.

/** Runs in the page before its scripts: what is drawn on a canvas is left out until `window.showScreen(true)`. */
export function leaveScreenBlank() {
  if (!navigator.gpu) return; // not a page of the app
  let isShown = false;
  const ofScreen = new WeakSet();
  const mark = (type, method, isOfScreen) => {
    const original = type.prototype[method];
    type.prototype[method] = function (...given) {
      const made = original.apply(this, given);
      if (isOfScreen(this, ...given)) ofScreen.add(made);
      return made;
    };
  };
  mark(GPUCanvasContext, 'getCurrentTexture', () => true);
  mark(GPUTexture, 'createView', (texture) => ofScreen.has(texture));
  mark(GPUCommandEncoder, 'beginRenderPass', (_, { colorAttachments }) => [...colorAttachments].some((to) => to && ofScreen.has(to.view)));
  for (const method of ['draw', 'drawIndexed']) {
    const original = GPURenderPassEncoder.prototype[method];
    GPURenderPassEncoder.prototype[method] = function (...given) {
      if (isShown || !ofScreen.has(this)) original.apply(this, given);
    };
  }
  window.showScreen = (shown) => {
    isShown = shown;
    window.dispatchEvent(new PageTransitionEvent('pageshow')); // a new frame is drawn
  };
}
