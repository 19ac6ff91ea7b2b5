/** How the names of model files end, in small letters. What a file holds decides, not its name. */
const kEndings = [
    ...['off', 'coff', 'noff', 'stoff', 'stl', 'obj', 'ply', 'xyz', 'pts', 'asc', '3mf', 'gltf'],
    ...[
        'glb',
        'dae',
        'x3d',
        'amf',
        'fbx',
        'step',
        'stp',
        'iges',
        'igs',
        'nrrd',
        'nii',
        'binvox',
        'npy',
        'gz',
        'zip',
    ],
] as const;

/** For the `accept` of a file field. */
export const kAccepted = [...kEndings.map((ending) => `.${ending}`), 'model/*', 'text/plain'].join(
    ',',
);

export function isModelName(name: string): boolean {
    const ending = name.slice(name.lastIndexOf('.') + 1).toLowerCase();
    return !name.startsWith('.') && (kEndings as readonly string[]).includes(ending);
}
