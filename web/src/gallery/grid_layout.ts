/** Where the cards of a grid lie, in CSS pixels. */
export interface GridLayout {
    columns: number;
    cardWidth: number;
    cardHeight: number;
    gap: number;
}

/** Columns are at least so wide, where two of them are not wider than the grid. */
const kLeastWidth = 168;
/** Below the picture, which is as high as the card is wide. */
const kTextHeight = 92;

export function gridLayout(width: number): GridLayout {
    const gap = width < 560 ? 12 : 18;
    const columns = Math.max(2, Math.floor((width + gap) / (kLeastWidth + gap)));
    const cardWidth = Math.max(1, (width - gap * (columns - 1)) / columns);
    return { columns, cardWidth, cardHeight: cardWidth + kTextHeight, gap };
}

export function gridHeight(layout: GridLayout, total: number): number {
    const rows = Math.ceil(total / layout.columns);
    return Math.max(0, rows * (layout.cardHeight + layout.gap) - layout.gap);
}

export function placeOf(layout: GridLayout, index: number): { x: number; y: number } {
    const column = index % layout.columns;
    const row = (index - column) / layout.columns;
    return {
        x: column * (layout.cardWidth + layout.gap),
        y: row * (layout.cardHeight + layout.gap),
    };
}

/** The cards of all rows between two heights of the grid, `end` left out. */
export function cardsBetween(
    layout: GridLayout,
    total: number,
    top: number,
    bottom: number,
): { first: number; end: number } {
    const step = layout.cardHeight + layout.gap;
    const firstRow = Math.max(0, Math.floor(top / step));
    const endRow = Math.max(firstRow, Math.ceil(bottom / step));
    return {
        first: Math.min(total, firstRow * layout.columns),
        end: Math.min(total, endRow * layout.columns),
    };
}
