/** What the tests use of gltf-validator, which has no types of its own. */
export interface Report {
    issues: {
        numErrors: number;
        numWarnings: number;
        messages: { code: string; message: string; severity: number; pointer: string }[];
    };
    info: { hasSkins: boolean; totalTriangleCount: number };
}

export function validateBytes(file: Uint8Array): Promise<Report>;
