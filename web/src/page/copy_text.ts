/** False where the browser does not allow it, as on pages that are not of this machine or encrypted. */
export async function copyText(text: string): Promise<boolean> {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false;
    }
}
