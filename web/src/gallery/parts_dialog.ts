import type { Client, HeldModel } from '../api/client';
import type { QueryModel, UpAxis } from '../api/elements';
import { codePart } from '../page/code_part';
import { element } from '../page/element';
import { say } from '../words/say';
import { partFile } from './part_query';
import { type ViewerDialog, viewerDialog } from './viewer_dialog';

export interface PartsOptions {
    model: HeldModel;
    query: QueryModel;
    up: UpAxis;
    posed: string;
    onPose: (posed: string) => void;
    /** Searches for models that have what a file holds. */
    onFind: (part: File) => void;
    onClose: () => void;
}

/** A model cut into its parts and ready to be posed. */
export function partsDialog(
    { model, query, up, posed, onPose, onFind, onClose }: PartsOptions,
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
            const find = async (part: number): Promise<void> => {
                const mesh = await client.mesh(model, signal);
                const title = say('{name}, part {number}', { name, number: part + 1 });
                onFind(partFile(title, mesh, segments.labels, part));
            };
            return partsView({
                name,
                skeleton,
                segments,
                rig,
                up,
                posed,
                onPose,
                onFind: (part) => void find(part),
            });
        },
        onClose,
    });
}
