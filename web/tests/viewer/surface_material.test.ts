import { expect, it } from 'vitest';

import { surfaceMaterial } from '../../src/viewer/surface_material';

it('lets the inside show through and hides nothing behind it', () => {
    const material = surfaceMaterial({
        body: '#ff0000',
        rim: '#0000ff',
        bodyOpacity: 0.1,
        rimOpacity: 0.6,
    });
    expect(material.transparent).toBe(true);
    expect(material.depthWrite).toBe(false);
    expect(material.uniforms.body?.value.getHexString()).toBe('ff0000');
    expect(material.uniforms.rim_opacity?.value).toBe(0.6);
});
