export type Field = string | number | null;

/**
 * Quoted where it has to be (RFC 4180). A spreadsheet takes what begins like a formula for one, and
 * names come from files: such a name gets an apostrophe in front.
 */
function quoted(field: Field): string {
    const text = String(field ?? '');
    const plain = typeof field === 'string' && /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
    return /[",\r\n]/.test(plain) ? `"${plain.replaceAll('"', '""')}"` : plain;
}

export type Columns<Row> = readonly (readonly [name: string, of: (row: Row) => Field])[];

/** A line for each row below one of names. */
export function csv<Row>(rows: readonly Row[], columns: Columns<Row>): string {
    const lines = [
        columns.map(([name]) => name),
        ...rows.map((row) => columns.map(([, of]) => quoted(of(row)))),
    ];
    return lines.map((line) => `${line.join(',')}\r\n`).join('');
}
