import { expect, it } from 'vitest';

import { noWebGlNotice, queryView } from '../../src/viewer/query_view';
import { kMesh, kSkeleton } from '../sample';

it('says plainly that there is no 3D picture without WebGL', () => {
    const view = queryView({ name: 'elephant', mesh: kMesh, skeleton: kSkeleton, up: 'y' });
    expect(view.node.textContent).toBe(noWebGlNotice().textContent);
    expect(view.node.textContent).toContain('WebGL');
    expect(() => view.dispose()).not.toThrow();
});
