let answer: boolean | null = null;

/**
 * Asked before three.js is, because its renderer throws where there is no WebGL 2. Browsers allow only
 * some contexts at once and give back the oldest: the question is put once.
 */
export function hasWebGl(): boolean {
    if (answer === null) {
        const context = document.createElement('canvas').getContext('webgl2');
        context?.getExtension('WEBGL_lose_context')?.loseContext();
        answer = context !== null;
    }
    return answer;
}
