import '../styles/viewer.css';
import type { PreviewMesh, UpAxis } from '../api/elements';
import type { Skeleton } from '../api/types';
import { element } from '../page/element';
import { OrbitSource } from './orbit_input';
import { Pane } from './pane';
import { readAccent } from './theme';
import { hasWebGl } from './webgl';
import { say } from '../words/say';

export interface View {
    node: HTMLElement;
    dispose(): void;
}

export function noWebGlNotice(): HTMLElement {
    return element(
        'p',
        { class: 'no-webgl' },
        say('This browser shows no 3D pictures (WebGL is off or missing).'),
    );
}

export interface ViewedModel {
    name: string;
    mesh: PreviewMesh | null;
    skeleton: Skeleton;
    up: UpAxis;
    /** Of its lengths; null: its file names none. */
    unit: string | null;
}

/** One model alone, its skeleton in the page's accent colour. */
export function queryView({ name, mesh, skeleton, up }: Omit<ViewedModel, 'unit'>): View {
    if (!hasWebGl()) {
        return { node: noWebGlNotice(), dispose: () => {} };
    }
    const accent = readAccent();
    return new Pane({
        mesh,
        skeleton,
        branchColors: new Map(skeleton.branches.map((branch) => [branch.id, accent])),
        label: say('{name} with its skeleton', { name }),
        orbit: new OrbitSource(),
        up,
        onHover: () => {},
    });
}
