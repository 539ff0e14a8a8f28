#pragma once

namespace scree {

/// A node of the profiles of lines a texel apart: of one, and of the next a column further.
struct LineNode {
    int row = 0, column = 0;     ///< of texel centres at the node, or before it
    float along = 0, across = 0; ///< of the way from there to the next row and column, [0, 1]
    float drop = 0;              ///< of the line of sight since the node before, in steps
};

/// How lines go through a row of texels: the rows and columns of texel centres and of texel edges
/// that they cross, in order.
///
/// All lines of a sweep cross columns, each its own, at the same places. Between two nodes the
/// bilinear surface has no kink, and there is one texel.
struct LinePath {
    /// Lines in one texel each.
    struct Piece {
        int texel = 0;          ///< its column
        int begin = 0, end = 0; ///< nodes behind its beginning; the last is where the texel ends
    };
    static constexpr int kMostNodes = 5, kMostPieces = 3; ///< a column more than a shift of 1 has

    LineNode beginning; ///< on the row's near edge
    LineNode nodes[kMostNodes];
    Piece pieces[kMostPieces];
    int node_count = 0, piece_count = 0;

    /// row                   the way through it begins and ends half a row from its texel centres
    /// away                  +1 where rows' numbers grow on the way, or -1
    /// enter, centre, leave  columns, counted from texel centres, where it begins, is half over and
    ///                       ends
    /// columns               columns are crossed too, up to 1 of texel centres and of edges each;
    ///                       else there is one piece, and two nodes
    LinePath(int row, int away, double enter, double centre, double leave, bool columns);

private:
    [[nodiscard]] LineNode node(double past_centre, double drop, int column, float across) const;
    void add(double past_centre, int column, float across);

    int row_, away_;
    double last_ = -0.5; ///< node, in rows away from the row's centres
};

} // namespace scree
