// What twice a gap on @what@ must exceed, for each clearance D:
// (2 + D) (|x| + |y| + |z|) + D max(|x|, |y|, |z|). Latency @latency@.
module @name@ #(
  parameter C_W = @c_w@, // bits of a component
  parameter L_W = @l_w@  // bits of a limit
) (
  input  wire                  clk,  // clock
  input  wire signed [C_W-1:0] x,    // component
  input  wire signed [C_W-1:0] y,    // component
  input  wire signed [C_W-1:0] z,    // component
//@ if two_limits
  output wire [2*L_W-1:0]      limit // for each clearance, the inner in the lower half
//@ else
  output wire [L_W-1:0]        limit // of the clearance
//@ end
);
  reg [C_W-1:0] size_x_q;
  reg [C_W-1:0] size_y_q;
  reg [C_W-1:0] size_z_q;
  reg [C_W+1:0] sum_q;

  always @(posedge clk) begin
    size_x_q <= x[C_W-1] ? -x : x;
    size_y_q <= y[C_W-1] ? -y : y;
    size_z_q <= z[C_W-1] ? -z : z;
    sum_q <= {2'd0, size_x_q} + {2'd0, size_y_q} + {2'd0, size_z_q};
  end
//@ if registered

  reg [C_W+1:0] sum_q2;

  always @(posedge clk) begin
    sum_q2 <= sum_q;
  end
//@ end
//@ if most

  reg [C_W-1:0] most_q;
//@ if registered
  reg [C_W-1:0] most_xy_q;
  reg [C_W-1:0] size_z_q2;

  always @(posedge clk) begin
    most_xy_q <= (size_x_q > size_y_q) ? size_x_q : size_y_q;
    size_z_q2 <= size_z_q;
    most_q <= (most_xy_q > size_z_q2) ? most_xy_q : size_z_q2;
  end
//@ else
  wire [C_W-1:0] most_xy;

  assign most_xy = (size_x_q > size_y_q) ? size_x_q : size_y_q;
  always @(posedge clk) begin
    most_q <= (most_xy > size_z_q) ? most_xy : size_z_q;
  end
//@ end
//@ end

  // (2 + D) sum + D most
  reg [L_W-1:0] limit_1_q;
  reg [L_W-1:0] limit_2_q; //@ two_limits
//@ if parts
  reg [L_W-1:0] of_sum_1_q;
  reg [L_W-1:0] of_most_1_q;
  reg [L_W-1:0] of_sum_2_q; //@ two_limits
  reg [L_W-1:0] of_most_2_q; //@ two_limits
//@ end

  always @(posedge clk) begin
//@ if parts
    of_sum_1_q <= @of_sum_1@;
    of_most_1_q <= @of_most_1@;
    limit_1_q <= of_sum_1_q + of_most_1_q;
//@ if two_limits
    of_sum_2_q <= @of_sum_2@;
    of_most_2_q <= @of_most_2@;
    limit_2_q <= of_sum_2_q + of_most_2_q;
//@ end
//@ else
    limit_1_q <= @limit_1@;
    limit_2_q <= @limit_2@; //@ two_limits
//@ end
  end

  assign limit = {limit_2_q, limit_1_q}; //@ two_limits
  assign limit = limit_1_q; //@ !two_limits
endmodule
