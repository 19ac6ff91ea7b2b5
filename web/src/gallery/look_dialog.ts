import type { PreviewMesh, QueryModel, UpAxis } from '../api/elements';
import { codePart } from '../page/code_part';
import { element } from '../page/element';
import { formatSize } from '../page/format';
import { say } from '../words/say';
import { branchFile } from './part_query';
import { type ViewerDialog, viewerDialog } from './viewer_dialog';

export interface LookOptions {
    query: QueryModel;
    mesh: PreviewMesh | null;
    up: UpAxis;
    /** Searches for models that have what a file holds. */
    onFind: (part: File) => void;
    onClose: () => void;
}

/** A model alone, as large as there is room. */
export function lookDialog({ query, mesh, up, onFind, onClose }: LookOptions): ViewerDialog {
    const { name, skeleton, unit } = query;
    return viewerDialog({
        title: element('span', {}, name),
        actions: null,
        async load() {
            const { lookView } = await codePart(() => import('../viewer/look_view'));
            return lookView({
                model: { name, mesh, skeleton, up, unit },
                about:
                    mesh && element('p', { class: 'match-summary' }, formatSize(mesh.bounds, unit)),
                onFind: (branch) => onFind(branchFile(say('{name}, branch', { name }), branch)),
            });
        },
        onClose,
    });
}
