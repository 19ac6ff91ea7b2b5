/** Asked before three.js is, because its renderer throws where there is no WebGL 2. */
export function hasWebGl(): boolean {
    const context = document.createElement('canvas').getContext('webgl2');
    // Browsers allow only some contexts at once; this one is given back at once.
    context?.getExtension('WEBGL_lose_context')?.loseContext();
    return context !== null;
}
