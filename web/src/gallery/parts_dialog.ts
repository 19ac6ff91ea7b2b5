import type { Client } from '../api/client';
import type { QueryModel, UpAxis } from '../api/elements';
import { element } from '../page/element';
import { type ViewerDialog, viewerDialog } from './viewer_dialog';

export interface PartsOptions {
    id: number;
    query: QueryModel;
    up: UpAxis;
    onClose: () => void;
}

/** A model of the collection, cut into its parts and ready to be posed. */
export function partsDialog(
    { id, query, up, onClose }: PartsOptions,
    client: Client,
): ViewerDialog {
    return viewerDialog({
        title: element('span', {}, `Parts of ${query.name}`),
        actions: null,
        async load(signal) {
            const [{ partsView }, segments, rig] = await Promise.all([
                import('../viewer/parts_view'),
                client.segments(id, signal),
                client.rig(id, signal),
            ]);
            return partsView({ name: query.name, skeleton: query.skeleton, segments, rig, up });
        },
        onClose,
    });
}
