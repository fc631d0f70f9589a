from onika.model.preferences import STATUS_COLUMNS, Preferences


def test_the_default_columns_are_columns_the_status_view_knows() -> None:
    assert set(Preferences().status_columns) <= set(STATUS_COLUMNS)  # R-A11, R-B12
    assert len(set(STATUS_COLUMNS)) == 22
