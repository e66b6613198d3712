// The measures of the stage, in its own units: the structure is always as long as this, whatever it is in metres.

export const LENGTH = 10;
export const THICKNESS = LENGTH / 18;
export const DEPTH = 1.5;
export const REACH = 1.75; // how far the structure should deflect at most
