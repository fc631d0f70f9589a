"""What is seen in pictures: a colour, a point that was seen before; and how a camera moves to see it elsewhere."""
