export const AR: any;
