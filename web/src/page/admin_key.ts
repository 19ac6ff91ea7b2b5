const kStored = 'ossuary.admin-key';

/** The administrator's key of this session; empty: none was given. It goes with the tab. */
export function adminKey(): string {
    try {
        return sessionStorage.getItem(kStored) ?? '';
    } catch {
        return '';
    }
}

export function keepAdminKey(key: string): void {
    try {
        if (key === '') {
            sessionStorage.removeItem(kStored);
        } else {
            sessionStorage.setItem(kStored, key);
        }
    } catch {
        // Then it has to be given again on the next page.
    }
}
