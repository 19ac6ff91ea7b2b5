import { ApiError, localFileFault } from '../api/problem';
import { isModelName } from './model_endings';
import { say } from '../words/say';

/** More than this are more than anyone means to search with at once. */
export const kMostFiles = 50;

function children(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
    const reader = folder.createReader();
    const all: FileSystemEntry[] = [];
    return new Promise((resolve, reject) => {
        // Browsers give a hundred at a time.
        const next = (): void =>
            reader.readEntries((some) => {
                all.push(...some);
                if (some.length === 0) {
                    resolve(all);
                } else {
                    next();
                }
            }, reject);
        next();
    });
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
    return new Promise((resolve, reject) => entry.file(resolve, reject));
}

/** Adds the models in a folder, and further down, to `found`. */
async function collect(folder: FileSystemDirectoryEntry, found: File[]): Promise<void> {
    const entries = await children(folder);
    entries.sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
    for (const entry of entries) {
        if (found.length >= kMostFiles) {
            return;
        }
        if (entry.isDirectory) {
            await collect(entry as FileSystemDirectoryEntry, found);
        } else if (isModelName(entry.name)) {
            found.push(await fileOf(entry as FileSystemFileEntry));
        }
    }
}

function noModels(folder: string): ApiError {
    return new ApiError({
        title: say('No models in the folder'),
        status: 0,
        detail: say('{folder}: no file in it, or further down, is named like a model.', { folder }),
        code: 'local_folder',
    });
}

async function modelsIn(folder: FileSystemDirectoryEntry): Promise<File[]> {
    const found: File[] = [];
    try {
        await collect(folder, found);
    } catch {
        throw localFileFault(folder.name);
    }
    if (found.length === 0) {
        throw noModels(folder.name);
    }
    return found;
}

/**
 * The files of a drop or of a clipboard: those named as they are, and of folders what is named like
 * a model. Errors: local_file, local_folder.
 */
export async function filesOf(transfer: DataTransfer): Promise<File[]> {
    // What was dropped can be asked for only now, within the event.
    const entries = [...(transfer.items ?? [])].flatMap((item) => item.webkitGetAsEntry?.() ?? []);
    const folders = entries.filter((entry) => entry.isDirectory) as FileSystemDirectoryEntry[];
    const names = new Set(folders.map(({ name }) => name));
    const plain = [...transfer.files].filter(({ name }) => !names.has(name));
    const found: File[] = [...plain];
    for (const folder of folders) {
        found.push(...(await modelsIn(folder)));
    }
    return found.slice(0, kMostFiles);
}
