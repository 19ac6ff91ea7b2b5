import { LineSegments, Mesh, type Object3D, SkinnedMesh } from 'three';

/** Frees what the meshes below hold on the graphics card, each once, and takes them out. */
export function disposeBelow(root: Object3D): void {
    const seen = new Set<{ dispose(): void }>();
    root.traverse((object) => {
        if (object instanceof Mesh || object instanceof LineSegments) {
            seen.add(object.geometry);
            seen.add(object.material);
        }
        if (object instanceof SkinnedMesh) {
            seen.add(object.skeleton);
        }
    });
    for (const resource of seen) {
        resource.dispose();
    }
    root.clear();
}
