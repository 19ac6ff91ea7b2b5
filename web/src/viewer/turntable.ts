import '../styles/viewer.css';
import type { PreviewMesh, UpAxis } from '../api/elements';
import { element } from '../page/element';
import { ModelScene } from './model_scene';
import { kFirstOrbit, turned } from './orbit';
import { OrbitSource } from './orbit_input';
import { Picture } from './picture';
import { readViewerTheme } from './theme';
import { hasWebGl } from './webgl';

/** As the pictures have it that it takes the place of. */
const kBody = '#d8cfbd';
const kRim = '#857c6c';
const kRadiansPerMs = (2 * Math.PI) / 7000;

/** Shows a model that turns in `host`. Returns what ends it and frees what it holds. */
export function turntable(host: HTMLElement, mesh: PreviewMesh, up: UpAxis): () => void {
    if (!hasWebGl()) {
        return () => {};
    }
    const theme = readViewerTheme();
    const orbit = new OrbitSource();
    const picture = new Picture({ label: '', orbit, up, beforeDraw: () => {}, controls: false });
    const skeleton = { unit: 'model', nodes: [], branches: [] } as const;
    const model = new ModelScene(
        { mesh, skeleton: { ...skeleton, nodes: [], branches: [] }, branchColors: new Map() },
        { ...theme, surface: { ...theme.surface, body: kBody, rim: kRim } },
    );
    model.opacity = 1;
    picture.stand.add(model.root);
    const node = element('span', { class: 'turntable', 'aria-hidden': 'true' }, picture.node);
    host.append(node);
    const started = performance.now();
    let frame = 0;
    const turn = (now: number): void => {
        orbit.set(turned(kFirstOrbit, (now - started) * kRadiansPerMs, 0));
        frame = requestAnimationFrame(turn);
    };
    frame = requestAnimationFrame(turn);
    return () => {
        cancelAnimationFrame(frame);
        model.dispose();
        picture.dispose();
        node.remove();
    };
}
