use super::*;

#[test]
fn lines_with_the_type_of_their_block_are_dashed_as_its_insert_specifies() {
    let table = "0 LTYPE 2 Dashed 49 3 49 -2 0 LAYER 2 walls 6 DASHED";
    let block = "0 BLOCK 2 a 0 LINE 6 ByBlock 10 0 20 0 11 20 21 0 0 ENDBLK \
         0 BLOCK 2 b 0 INSERT 2 a 6 BYBLOCK 10 0 20 0 0 ENDBLK";
    let count = |insert: &str| {
        let text = file(table, block, insert);
        let strokes = draw_text(&text).0.layers.remove(0).strokes;
        strokes.len()
    };
    assert_eq!(count("0 INSERT 2 a 6 Dashed 10 0 20 0"), 4);
    assert_eq!(count("0 INSERT 2 a 8 WALLS 10 0 20 0"), 4);
    assert_eq!(count("0 INSERT 2 b 6 DASHED 10 0 20 0"), 4);
    for solid in [
        "0 INSERT 2 a 10 0 20 0",
        "0 INSERT 2 a 8 walls 6 CONTINUOUS 10 0 20 0",
        "0 LINE 6 BYBLOCK 10 0 20 0 11 20 21 0",
    ] {
        assert_eq!(count(solid), 1, "{solid}");
    }
}
