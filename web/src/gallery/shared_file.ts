/** Files that may hold several models, and how a model in one is named: `plate.3mf#Wheel`. */
const kShared = /([^/#]*\.(?:zip|3mf|gltf|glb|dae|x3d|amf|fbx|obj|stl)(?:\.gz)?)#./i;

/** The name of the file that a model shares with others; null where it has one of its own. */
export function sharedFileOf(path: string): string | null {
    return kShared.exec(path)?.[1] ?? null;
}
