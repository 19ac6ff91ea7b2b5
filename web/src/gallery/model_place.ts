/** Files that may hold several models, and how a model in one is named: `plate.3mf#Wheel`. */
const kWithin = /\.(?:zip|3mf|gltf|glb|dae|x3d|amf|fbx|obj|stl)(?:\.gz)?#./i;

/**
 * In what a model lies, by which it is told from its namesakes: its folder below the one that was
 * indexed, or the file that it shares with others; null where it lies at the top.
 */
export function placeOfModel(path: string): string | null {
    const within = kWithin.exec(path);
    const end = within ? path.indexOf('#', within.index) : path.lastIndexOf('/');
    return end > 0 ? path.slice(0, end) : null;
}
