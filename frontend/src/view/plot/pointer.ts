// Clicking and dragging along an element.

/** Calls back with the distance from the left edge [px], on a press and while it is dragged. */
export function follow(element: HTMLElement, to: (left: number) => void): void {
  const place = (event: PointerEvent) => {
    const { left, width } = element.getBoundingClientRect();
    to(Math.min(Math.max(event.clientX - left, 0), width));
  };
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    place(event);
  });
  element.addEventListener("pointermove", (event) => {
    if (element.hasPointerCapture(event.pointerId)) place(event);
  });
}
