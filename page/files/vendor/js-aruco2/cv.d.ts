export const CV: any;
