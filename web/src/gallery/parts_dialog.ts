import type { Client, HeldModel } from '../api/client';
import type { QueryModel, UpAxis } from '../api/elements';
import { codePart } from '../page/code_part';
import { element } from '../page/element';
import { type ViewerDialog, viewerDialog } from './viewer_dialog';

export interface PartsOptions {
    model: HeldModel;
    query: QueryModel;
    up: UpAxis;
    posed: string;
    onPose: (posed: string) => void;
    onClose: () => void;
}

/** A model cut into its parts and ready to be posed. */
export function partsDialog(
    { model, query, up, posed, onPose, onClose }: PartsOptions,
    client: Client,
): ViewerDialog {
    return viewerDialog({
        title: element('span', {}, `Parts of ${query.name}`),
        actions: null,
        async load(signal) {
            const [{ partsView }, segments, rig] = await Promise.all([
                codePart(() => import('../viewer/parts_view')),
                client.segments(model, signal),
                client.rig(model, signal),
            ]);
            const { name, skeleton } = query;
            return partsView({ name, skeleton, segments, rig, up, posed, onPose });
        },
        onClose,
    });
}
