"""What grippers do in worlds from files: what they take along where there are no forces, and who watches them."""
