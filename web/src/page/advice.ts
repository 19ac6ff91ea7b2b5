import type { Text } from '../words/say';

/** What to do about files that could not be indexed, by the beginning of the stable code. */
const kAdvice: readonly (readonly [code: string, advice: Text])[] = [
    ['file_too_large', 'Reduce the file, or raise the limit of the server.'],
    ['file_', 'See whether the file is still there and may be read, then index again.'],
    ['format_', 'Export it as OFF, STL, OBJ, PLY, 3MF or glTF.'],
    [
        'mesh_',
        'Nothing solid is in it: open it in a modelling program and export the surface again.',
    ],
    [
        'solid_',
        'Nothing solid is in it: open it in a modelling program and export the surface again.',
    ],
    ['model_too_many', 'Reduce its triangles in a modelling program.'],
    ['reader_time', 'It takes too long to read: reduce it, or export it in another format.'],
    [
        'reader_memory',
        'It takes too much memory to read: reduce it, or export it in another format.',
    ],
    ['reader_', 'It cannot be read safely: export it in another format.'],
    ['archive_', 'Unpack the archive and add what is in it.'],
    ['gzip_', 'Unpack the archive and add what is in it.'],
    ['cancelled', 'It took longer than a model may: reduce it, or give models more time.'],
    [
        'upload_abandoned',
        'The server ended in its midst several times: reduce it before it is added again.',
    ],
    ['index_busy', 'Another program writes to the index: try again later.'],
    ['index_', 'The index is in trouble: see the log of the server, and run ossuary verify.'],
    ['', 'The file is damaged or not what its name says: export it again.'],
];

export function adviceFor(code: string): Text {
    return (kAdvice.find(([start]) => code.startsWith(start)) ?? kAdvice[0])?.[1] as Text;
}
